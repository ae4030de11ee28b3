#include "rtu_emulator.h"

#include <QElapsedTimer>

using namespace Qt::StringLiterals;
using namespace lds::test;

#ifndef LDS_HAVE_LIBMODBUS

class LibmodbusRtuClientTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void libmodbusIsThere()
    {
        QFAIL("libmodbus-dev was not there when this was built; scripts/setup installs it");
    }
};

#else

#include <cerrno>
#include <modbus/modbus.h>

namespace {

constexpr int wire(int number) { return number - 400001; }

qint32 lowWordFirst(const uint16_t* words) { return qint32(quint32(words[1]) << 16 | words[0]); }

/// A connection of libmodbus, closed with the object.
class Client {
public:
    Client(const QString& link, const LineChoice& line, int unit)
        : m_modbus(modbus_new_rtu(QFile::encodeName(link).constData(), line.speed, line.parity, 8,
                                  line.stopBits()))
    {
        modbus_set_slave(m_modbus, unit);
        modbus_set_response_timeout(m_modbus, 5, 0);
        m_connected = modbus_connect(m_modbus) == 0;
    }
    ~Client()
    {
        modbus_close(m_modbus);
        modbus_free(m_modbus);
    }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    bool isConnected() const { return m_connected; }
    void setTimeoutMs(int milliseconds)
    {
        modbus_set_response_timeout(m_modbus, 0, uint32_t(milliseconds) * 1000);
    }
    void setUnit(int unit) { modbus_set_slave(m_modbus, unit); }
    modbus_t* get() const { return m_modbus; }
    /// −1 when it cannot be read.
    int read(int number) const
    {
        uint16_t value = 0;
        return modbus_read_registers(m_modbus, wire(number), 1, &value) == 1 ? value : -1;
    }
    bool write(int number, int value) const
    {
        return modbus_write_register(m_modbus, wire(number), uint16_t(value)) == 1;
    }

private:
    modbus_t* m_modbus;
    bool m_connected = false;
};

} // namespace

class LibmodbusRtuClientTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void readsAndWritesAtEachSetting_data() { lineChoices(); }
    void readsAndWritesAtEachSetting();
    void isToldEachErrorCode();
    void aPollTakesTheTimeOfTheLine_data();
    void aPollTakesTheTimeOfTheLine();
    void aBroadcastIsObeyedWithoutAnAnswer();
    void reachesTwoUnitsOnOneLine();
    void twoUnitsAtOneAddressAreNoAnswer();
    void getsNoAnswerAtOtherSettings();
    void reopensTheLine();
    void changesTheSensorsAddressAndSpeed();
    void aSlowSensorIsWaitedFor();

private:
    std::unique_ptr<RtuEmulator> m_emulator;
};

void LibmodbusRtuClientTest::initTestCase()
{
    m_emulator = std::make_unique<RtuEmulator>(u"HL-G203B-S-MK"_s, QStringList{u"--unit"_s, u"42"_s});
    QVERIFY2(m_emulator->rtu() == m_emulator->link(), m_emulator->errors());
}

void LibmodbusRtuClientTest::readsAndWritesAtEachSetting()
{
    QFETCH(int, speed);
    QFETCH(char, parity);
    QVERIFY(m_emulator->use({speed, parity}));
    const Client client(m_emulator->link(), {speed, parity}, 42);
    QVERIFY(client.isConnected());

    uint16_t first[125] = {};
    uint16_t second[36] = {};
    QCOMPARE(modbus_read_registers(client.get(), wire(400011), 125, first), 125);
    QCOMPARE(modbus_read_registers(client.get(), wire(400136), 36, second), 36);
    QCOMPARE(lowWordFirst(first + 105), 10'000); // span
    QCOMPARE(second[400169 - 400136], uint16_t(42));

    uint8_t coils[64] = {};
    QCOMPARE(modbus_read_bits(client.get(), 0, 64, coils), 64);
    for (int number = 1; number <= 64; ++number)
        QCOMPARE(int(coils[number - 1]), number == 4 || number == 7 || number == 11 ? 1 : 0);

    QVERIFY(client.write(400110, speed % 65'536));
    QCOMPARE(client.read(400110), speed % 65'536);
    const uint16_t window[] = {0x1110, 0x0001, 0xeef0, 0xfffe};
    QCOMPARE(modbus_write_registers(client.get(), wire(400101), 4, window), 4);
    uint16_t words[4] = {};
    QCOMPARE(modbus_read_registers(client.get(), wire(400101), 4, words), 4);
    QCOMPARE(lowWordFirst(words), 69'904);
    QCOMPARE(lowWordFirst(words + 2), -69'904);
}

void LibmodbusRtuClientTest::isToldEachErrorCode()
{
    QVERIFY(m_emulator->use({}));
    const Client client(m_emulator->link(), {}, 42);
    uint16_t words[2] = {};
    errno = 0;
    QCOMPARE(modbus_read_input_registers(client.get(), wire(400101), 1, words), -1);
    QCOMPARE(errno, EMBXILFUN);
    QCOMPARE(modbus_read_registers(client.get(), wire(400051), 1, words), -1);
    QCOMPARE(errno, EMBXILADD);
    QVERIFY(!client.write(400129, 1));
    QCOMPARE(errno, EMBXILADD);
    QVERIFY(!client.write(400054, 1));
    QCOMPARE(errno, EMBXILVAL);
    const uint16_t inverted[] = {0, 0, 1, 0}; // HIGH below LOW
    QCOMPARE(modbus_write_registers(client.get(), wire(400101), 4, inverted), -1);
    QCOMPARE(errno, EMBXILVAL);
    QVERIFY(!client.write(400146, 0)); // tuning was not started
    QCOMPARE(errno, EMBXSFAIL);
    QVERIFY(client.read(400116) > 0);
}

void LibmodbusRtuClientTest::aPollTakesTheTimeOfTheLine_data()
{
    QTest::addColumn<int>("speed");
    QTest::addColumn<qint64>("lineUs"); // 8 characters, the silence, 31 characters
    QTest::newRow("9600") << 9600 << 9'166 + 4'010 + 35'520LL;
    QTest::newRow("38400") << 38400 << 2'291 + 1'750 + 8'880LL;
    QTest::newRow("230400") << 230400 << 381 + 1'750 + 1'480LL;
}

/// Never faster than the line. How much slower is the machine's affair; the middle of many is shown.
void LibmodbusRtuClientTest::aPollTakesTheTimeOfTheLine()
{
    QFETCH(int, speed);
    QFETCH(qint64, lineUs);
    QVERIFY(m_emulator->use({speed, 'E'}));
    const Client client(m_emulator->link(), {speed, 'E'}, 42);
    QList<qint64> took;
    for (int time = 0; time < 41; ++time) {
        uint16_t words[13] = {};
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(modbus_read_registers(client.get(), wire(400011), 13, words), 13);
        took.append(timer.nsecsElapsed() / 1000);
    }
    std::sort(took.begin(), took.end());
    qDebug("%lld us on the line, %lld us taken", lineUs, took.at(20));
    QVERIFY2(took.first() >= lineUs, qPrintable(QString::number(took.first())));
}

void LibmodbusRtuClientTest::aBroadcastIsObeyedWithoutAnAnswer()
{
    TwoUnits units(1, 2);
    QVERIFY2(!units.line().isEmpty(), units.errors());
    Client client(units.link(), {}, MODBUS_BROADCAST_ADDRESS);
    client.setTimeoutMs(300);
    errno = 0;
    QVERIFY(!client.write(400109, 0)); // libmodbus waits for an answer all the same
    QCOMPARE(errno, ETIMEDOUT);
    client.setTimeoutMs(990);
    for (const int unit : {1, 2}) {
        client.setUnit(unit);
        QCOMPARE(client.read(400109), 0);
    }
}

void LibmodbusRtuClientTest::reachesTwoUnitsOnOneLine()
{
    TwoUnits units(5, 6);
    QVERIFY2(!units.line().isEmpty(), units.errors());
    Client client(units.link(), {}, 5);
    QVERIFY(client.write(400110, 555));
    client.setUnit(6);
    QVERIFY(client.write(400110, 666));
    QCOMPARE(client.read(400110), 666);
    client.setUnit(5);
    QCOMPARE(client.read(400110), 555);
    client.setUnit(7);
    client.setTimeoutMs(200);
    QCOMPARE(client.read(400110), -1);
    QCOMPARE(errno, ETIMEDOUT);
}

void LibmodbusRtuClientTest::twoUnitsAtOneAddressAreNoAnswer()
{
    TwoUnits units(5, 5);
    QVERIFY2(!units.line().isEmpty(), units.errors());
    Client client(units.link(), {}, 5);
    client.setTimeoutMs(300);
    for (int time = 0; time < 3; ++time) {
        uint16_t words[50] = {}; // on the line for 30 ms, while the second unit answers after 3 ms
        QCOMPARE(modbus_read_registers(client.get(), wire(400101), 50, words), -1);
        modbus_flush(client.get());
    }
}

void LibmodbusRtuClientTest::getsNoAnswerAtOtherSettings()
{
    QVERIFY(m_emulator->use({115200, 'N'}));
    for (const LineChoice& line :
         {LineChoice{9600, 'N'}, LineChoice{230400, 'N'}, LineChoice{115200, 'E'}, LineChoice{115200, 'O'}}) {
        Client client(m_emulator->link(), line, 42);
        client.setTimeoutMs(150);
        QCOMPARE(client.read(400116), -1);
        QCOMPARE(errno, ETIMEDOUT);
    }
    QCOMPARE(Client(m_emulator->link(), {115200, 'N'}, 42).read(400116), 10'000);
}

void LibmodbusRtuClientTest::reopensTheLine()
{
    QVERIFY(m_emulator->use({}));
    for (int time = 0; time < 20; ++time)
        QCOMPARE(Client(m_emulator->link(), {}, 42).read(400116), 10'000);
}

void LibmodbusRtuClientTest::changesTheSensorsAddressAndSpeed()
{
    RtuEmulator emulator(u"HL-G203B-S-MK"_s);
    QVERIFY2(!emulator.rtu().isEmpty(), emulator.errors());
    {
        const Client client(emulator.link(), {}, 1);
        QVERIFY(client.write(400169, 200));
        QVERIFY(client.write(400167, 0));
        QVERIFY(client.write(400168, 2));
        QCOMPARE(client.read(400169), 200); // still at 1 and at 38,400 bps
        QVERIFY(client.write(400171, 0));   // answered before it takes effect
    }
    const Client client(emulator.link(), {9600, 'O'}, 200);
    QCOMPARE(client.read(400169), 200);
}

void LibmodbusRtuClientTest::aSlowSensorIsWaitedFor()
{
    QTemporaryDir folder;
    QFile config(folder.filePath(u"config.json"_s));
    QVERIFY(config.open(QIODevice::WriteOnly));
    config.write(R"({"sensors":[{"sensor":"HL-G203B-S-MK","rtu":"line","unit":3,"answeringTimeMs":400}]})");
    config.close();
    EmulatorProcess emulator({u"--config"_s, config.fileName()});
    QVERIFY2(!emulator.line().isEmpty(), emulator.errors());
    Client client(folder.filePath(u"line"_s), {}, 3);
    client.setTimeoutMs(200);
    QCOMPARE(client.read(400116), -1);
    client.setTimeoutMs(990);
    QTRY_COMPARE(client.read(400116), 10'000); // when the late answer has gone by
}

#endif

QTEST_GUILESS_MAIN(LibmodbusRtuClientTest)
#include "tst_libmodbus_rtu_client.moc"

#include "emulator_process.h"

#include <QTest>

using namespace Qt::StringLiterals;
using lds::test::EmulatorProcess;

#ifndef LDS_HAVE_LIBMODBUS

class LibmodbusClientTest : public QObject {
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

/// libmodbus leaves the word order to its callers.
qint32 lowWordFirst(const uint16_t* words) { return qint32(quint32(words[1]) << 16 | words[0]); }

} // namespace

class LibmodbusClientTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();
    void readsEverySettingInTwoMessages();
    void readsCoils();
    void writesOneRegister();
    void writesSeveralRegistersAnd32BitValues();
    void seesTheMeasuredValueMove();
    void savesAndCarriesOutCommands();
    void isToldEachErrorCode();
    void severalClientsAreServedAtOnce();

private:
    std::unique_ptr<EmulatorProcess> m_emulator;
    modbus_t* m_modbus = nullptr;
};

void LibmodbusClientTest::initTestCase()
{
    m_emulator = std::make_unique<EmulatorProcess>(
        QStringList{u"--sensor"_s, u"HL-G203B-S-MK"_s, u"--modbus-port"_s, u"0"_s, u"--tool-port"_s, u"0"_s});
    QVERIFY2(m_emulator->modbusPort() > 0, m_emulator->errors());
    m_modbus = modbus_new_tcp("127.0.0.1", m_emulator->modbusPort());
    modbus_set_response_timeout(m_modbus, 5, 0);
    QCOMPARE(modbus_connect(m_modbus), 0);
}

void LibmodbusClientTest::cleanupTestCase()
{
    if (m_modbus) {
        modbus_close(m_modbus);
        modbus_free(m_modbus);
    }
}

void LibmodbusClientTest::readsEverySettingInTwoMessages()
{
    uint16_t first[125] = {};
    uint16_t second[36] = {};
    QCOMPARE(modbus_read_registers(m_modbus, wire(400011), 125, first), 125);
    QCOMPARE(modbus_read_registers(m_modbus, wire(400136), 36, second), 36);
    QCOMPARE(lowWordFirst(first + 90), 50'000);
    QCOMPARE(lowWordFirst(first + 92), -50'000);
    QCOMPARE(lowWordFirst(first + 105), 10'000); // span
    QCOMPARE(second[400153 - 400136], uint16_t(502));
    QCOMPARE(second[400158 - 400136], uint16_t(192));
}

void LibmodbusClientTest::readsCoils()
{
    uint8_t coils[64] = {};
    QCOMPARE(modbus_read_bits(m_modbus, 0, 64, coils), 64);
    for (int number = 1; number <= 64; ++number)
        QCOMPARE(int(coils[number - 1]), number == 4 || number == 7 || number == 11 ? 1 : 0);
}

void LibmodbusClientTest::writesOneRegister()
{
    QCOMPARE(modbus_write_register(m_modbus, wire(400110), 65'535), 1);
    uint16_t value = 0;
    QCOMPARE(modbus_read_registers(m_modbus, wire(400110), 1, &value), 1);
    QCOMPARE(value, uint16_t(65'535));
}

void LibmodbusClientTest::writesSeveralRegistersAnd32BitValues()
{
    const uint16_t window[] = {0x1111, 0x0001, 0xeeef, 0xfffe}; // HIGH 69905, LOW −69905
    QCOMPARE(modbus_write_registers(m_modbus, wire(400101), 4, window), 4);
    uint16_t words[4] = {};
    QCOMPARE(modbus_read_registers(m_modbus, wire(400101), 4, words), 4);
    QCOMPARE(lowWordFirst(words), 69'905);
    QCOMPARE(lowWordFirst(words + 2), -69'905);
}

void LibmodbusClientTest::seesTheMeasuredValueMove()
{
    const auto measured = [this] {
        uint16_t words[2] = {};
        modbus_read_registers(m_modbus, wire(400020), 2, words);
        return lowWordFirst(words);
    };
    const qint32 first = measured();
    QVERIFY(std::abs(first) < 50'000);
    QTRY_VERIFY(measured() != first);
}

void LibmodbusClientTest::savesAndCarriesOutCommands()
{
    for (const int number : {400054, 400056, 400171})
        QCOMPARE(modbus_write_register(m_modbus, wire(number), 0), 1);
    QCOMPARE(modbus_write_register(m_modbus, wire(400058), 2), 1);
    uint16_t bank = 0;
    QCOMPARE(modbus_read_registers(m_modbus, wire(400058), 1, &bank), 1);
    QCOMPARE(bank, uint16_t(2));
    QCOMPARE(modbus_write_register(m_modbus, wire(400062), 6), 1); // All Areas
    QCOMPARE(modbus_read_registers(m_modbus, wire(400058), 1, &bank), 1);
    QCOMPARE(bank, uint16_t(1));
}

void LibmodbusClientTest::isToldEachErrorCode()
{
    uint16_t words[2] = {};
    errno = 0;
    QCOMPARE(modbus_read_input_registers(m_modbus, wire(400101), 1, words), -1);
    QCOMPARE(errno, EMBXILFUN);
    QCOMPARE(modbus_read_registers(m_modbus, wire(400051), 1, words), -1);
    QCOMPARE(errno, EMBXILADD);
    QCOMPARE(modbus_write_register(m_modbus, wire(400129), 1), -1);
    QCOMPARE(errno, EMBXILADD);
    QCOMPARE(modbus_write_register(m_modbus, wire(400054), 1), -1);
    QCOMPARE(errno, EMBXILVAL);
    const uint16_t inverted[] = {0, 0, 1, 0}; // HIGH below LOW
    QCOMPARE(modbus_write_registers(m_modbus, wire(400101), 4, inverted), -1);
    QCOMPARE(errno, EMBXILVAL);
    QCOMPARE(modbus_write_register(m_modbus, wire(400146), 0), -1); // tuning was not started
    QCOMPARE(errno, EMBXSFAIL);
}

void LibmodbusClientTest::severalClientsAreServedAtOnce()
{
    const int toolPort = EmulatorProcess::port(m_emulator->ready(), QLatin1StringView("toolPort"));
    modbus_t* tool = modbus_new_tcp("127.0.0.1", toolPort);
    QCOMPARE(modbus_connect(tool), 0);
    QCOMPARE(modbus_write_register(tool, wire(400109), 0), 1);
    uint16_t eco = 1;
    QCOMPARE(modbus_read_registers(m_modbus, wire(400109), 1, &eco), 1);
    QCOMPARE(eco, uint16_t(0));
    modbus_close(tool);
    modbus_free(tool);
}

#endif

QTEST_GUILESS_MAIN(LibmodbusClientTest)
#include "tst_libmodbus_client.moc"

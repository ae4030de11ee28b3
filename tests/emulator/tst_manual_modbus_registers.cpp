// §5.2.4 and §5.2.5: what a Modbus client reads and writes where.
#include "manual_items.h"
#include "modbus_responder.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

QByteArray bigEndian(int word) { return {QByteArray(1, char(word >> 8)) + char(word)}; }

/// §5.2.4: the address in a message is the printed one less 400001.
QByteArray read(int number, int count) { return hex("03") + bigEndian(number - 400001) + bigEndian(count); }
QByteArray writeOne(int number, int value)
{
    return hex("06") + bigEndian(number - 400001) + bigEndian(value);
}
/// §5.2.5: the coil's address in a message is the printed one less 1.
QByteArray readCoil(int number) { return hex("01") + bigEndian(number - 1) + bigEndian(1); }

} // namespace

class ManualModbusRegistersTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup() { m_responder.reset(); }

    void valuesThatAreNoneHaveTheirNumbers();
    void theMeasuredValueIsRoundedDownTo100Nanometres_data();
    void theMeasuredValueIsRoundedDownTo100Nanometres();
    void peakIntensityIs65535WhileIndeterminate();
    void aSettingIsReadBackAsWritten_data();
    void aSettingIsReadBackAsWritten();
    void commandsTakeNothingButZero_data();
    void commandsTakeNothingButZero();
    void everyProhibitedRegisterIsRefused();
    void everyReadOnlyRegisterRefusesAWrite();
    void everyWriteOnlyRegisterRefusesARead();

    void everyCoilIsABitOfItsRegister();
    void judgmentCoilsFollowTheValue();
    void holdZeroAndLaserHaveTheirCoils();
    void notificationIsSetByEveryDetail();

private:
    QByteArray answer(const QByteArray& request) { return m_responder->answer(request); }
    bool coil(int number) { return answer(readCoil(number)) == hex("01 01 01"); }

    std::unique_ptr<ModbusResponder> m_responder;
};

void ManualModbusRegistersTest::init()
{
    setUp();
    m_responder = std::make_unique<ModbusResponder>(*m_sensor);
}

void ManualModbusRegistersTest::valuesThatAreNoneHaveTheirNumbers()
{
    const QByteArray measuredValue = read(400020, 2);
    QVERIFY(write(ItemId::Offset, 90'000));
    m_sensor->placeWorkpiece(6'000);
    QCOMPARE(answer(measuredValue), hex("03 04 7c00 0092")); // above the display range: +9,600,000
    QVERIFY(write(ItemId::Offset, -90'000));
    m_sensor->placeWorkpiece(-6'000);
    QCOMPARE(answer(measuredValue), hex("03 04 8400 ff6d")); // below it: −9,600,000
    QVERIFY(write(ItemId::Offset, 0));
    m_sensor->placeWorkpiece(-6'000);
    QCOMPARE(answer(measuredValue), hex("03 04 e890 ffff"));
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    QCOMPARE(answer(measuredValue), hex("03 04 6981 ff67")); // indeterminate: −9,999,999
    QVERIFY(write(ItemId::AlarmDigitalOutput, 1));
    m_sensor->setLight(Light::Insufficient);
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(answer(measuredValue), hex("03 04 967f 0098")); // alarm: +9,999,999
}

void ManualModbusRegistersTest::theMeasuredValueIsRoundedDownTo100Nanometres_data()
{
    QTest::addColumn<int>("place");
    QTest::addColumn<int>("span");
    QTest::addColumn<int>("read");
    QTest::newRow("up") << 1'001 << 9'999 << 1'000;     // 1,000.8999
    QTest::newRow("down") << -1'001 << 9'999 << -1'000; // towards zero: docs/conformance.md, open points
    QTest::newRow("exact") << 1'000 << 9'990 << 999;
}

void ManualModbusRegistersTest::theMeasuredValueIsRoundedDownTo100Nanometres()
{
    QFETCH(int, place);
    QFETCH(int, span);
    QFETCH(int, read);
    QVERIFY(write(ItemId::Span, span));
    m_sensor->placeWorkpiece(place);
    QCOMPARE(value(), read);
}

void ManualModbusRegistersTest::peakIntensityIs65535WhileIndeterminate()
{
    m_sensor->placeWorkpiece(0);
    const QByteArray normal = answer(read(400022, 1));
    QCOMPARE(normal.left(2), hex("03 02"));
    const int intensity = quint8(normal.at(2)) << 8 | quint8(normal.at(3));
    QVERIFY(intensity > 0 && intensity <= 1'023);
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    QCOMPARE(answer(read(400022, 1)), hex("03 02 ffff"));
}

void ManualModbusRegistersTest::aSettingIsReadBackAsWritten_data()
{
    const QList<ItemId> switches{ItemId::LaserStop, ItemId::KeyLock, ItemId::BankSwitching};
    addRows(switches + settingsChangedAlone());
}

void ManualModbusRegistersTest::aSettingIsReadBackAsWritten()
{
    QFETCH(int, item);
    const SettingItem& setting = hlG2(ItemId(item));
    const int number = setting.modbus->number;
    const Value changed = otherThanDefault(setting, m_sensor->model());
    if (setting.size == 4) {
        const QByteArray words = bigEndian(changed) + bigEndian(changed >> 16); // low word first
        QCOMPARE(answer(hex("10") + bigEndian(number - 400001) + hex("0002 04") + words),
                 hex("10") + bigEndian(number - 400001) + hex("0002"));
        QCOMPARE(answer(read(number, 2)), hex("03 04") + words);
        return;
    }
    QCOMPARE(answer(writeOne(number, changed)), writeOne(number, changed));
    QCOMPARE(answer(read(number, 1)), hex("03 02") + bigEndian(changed));
}

void ManualModbusRegistersTest::commandsTakeNothingButZero_data()
{
    addRows({ItemId::SetValueSaving, ItemId::MeasuredValueResetting, ItemId::Teaching1stPoint,
             ItemId::Teaching2ndPoint, ItemId::Teaching3rdPoint, ItemId::BrightnessTuning1stPoint,
             ItemId::BrightnessTuning2ndPoint, ItemId::ResettingCommunicationSettings});
}

void ManualModbusRegistersTest::commandsTakeNothingButZero()
{
    QFETCH(int, item);
    for (const int reserved : {1, 2, 255, 256})
        QCOMPARE(answer(writeOne(hlG2(ItemId(item)).modbus->number, reserved)), hex("86 03"));
}

void ManualModbusRegistersTest::everyProhibitedRegisterIsRefused()
{
    int seen = 0;
    for (int number = 400001; number < 400300; ++number) {
        if (!Catalog::hlG2().isUsageProhibited(quint16(number - 400001)))
            continue;
        ++seen;
        QCOMPARE(answer(read(number, 1)), hex("83 02"));
        QCOMPARE(answer(writeOne(number, 0)), hex("86 02"));
        QCOMPARE(answer(hex("10") + bigEndian(number - 400001) + hex("0001 02 0000")), hex("90 02"));
    }
    QCOMPARE(seen, 19); // §5.2.4
}

void ManualModbusRegistersTest::everyReadOnlyRegisterRefusesAWrite()
{
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (item.modbus && !item.isWritable())
            QVERIFY2(answer(writeOne(item.modbus->number, 0)) == hex("86 02"), item.key);
    }
}

void ManualModbusRegistersTest::everyWriteOnlyRegisterRefusesARead()
{
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (item.modbus && !item.isReadable())
            QVERIFY2(answer(read(item.modbus->number, 1)) == hex("83 02"), item.key);
    }
}

void ManualModbusRegistersTest::everyCoilIsABitOfItsRegister()
{
    const auto check = [this] {
        const QByteArray words = answer(read(400011, 4)).mid(2);
        for (int number = 1; number <= 64; ++number) {
            const int word =
                quint8(words.at((number - 1) / 16 * 2)) << 8 | quint8(words.at((number - 1) / 16 * 2 + 1));
            QCOMPARE(coil(number), ((word >> ((number - 1) % 16)) & 1) != 0);
        }
    };
    check();
    m_sensor->placeWorkpiece(60'000);
    m_sensor->setLife({SelfMonitoring::mostOperatingSeconds + 1, SelfMonitoring::mostMemoryWrites + 1});
    m_sensor->raiseError({120, 0});
    check();
    m_sensor->setReservedBits(true);
    check();
}

void ManualModbusRegistersTest::judgmentCoilsFollowTheValue()
{
    QVERIFY(write(ItemId::HighSetValue, 1'000));
    QVERIFY(write(ItemId::LowSetValue, -1'000));
    for (const auto& [place, output] : QList<std::pair<Value, int>>{{2'000, 3}, {0, 4}, {-2'000, 5}}) {
        m_sensor->placeWorkpiece(place);
        for (int number = 3; number <= 5; ++number) {
            QCOMPARE(coil(number), number == output);
            QCOMPARE(coil(number + 3), number == output); // at timer OFF
        }
    }
}

void ManualModbusRegistersTest::holdZeroAndLaserHaveTheirCoils()
{
    m_sensor->placeWorkpiece(100);
    QVERIFY(!coil(9) && !coil(10) && coil(11));
    QCOMPARE(answer(writeOne(400131, 1)), writeOne(400131, 1));
    QVERIFY(coil(9));
    QCOMPARE(answer(writeOne(400131, 0)), writeOne(400131, 0));
    QCOMPARE(answer(writeOne(400052, 1)), writeOne(400052, 1));
    QVERIFY(!coil(9) && coil(10));
    QCOMPARE(answer(writeOne(400150, 1)), writeOne(400150, 1));
    QVERIFY(!coil(11) && coil(2));
}

void ManualModbusRegistersTest::notificationIsSetByEveryDetail()
{
    m_sensor->placeWorkpiece(0);
    QVERIFY(!coil(12) && !coil(13) && !coil(14));
    m_sensor->placeWorkpiece(60'000);
    QVERIFY(coil(19) && coil(14) && !coil(13) && !coil(12));
    m_sensor->placeWorkpiece(0);
    m_sensor->setLife({SelfMonitoring::mostOperatingSeconds + 1, 0});
    QVERIFY(coil(33) && !coil(34) && coil(14) && coil(13) && !coil(12));
    m_sensor->setLife({0, SelfMonitoring::mostMemoryWrites + 1});
    QVERIFY(!coil(33) && coil(34) && coil(14) && coil(13) && !coil(12));
    m_sensor->setFault(SensorFault::LaserCircuitError, true);
    QVERIFY(coil(49) && coil(14) && !coil(13) && coil(12)); // Caution only while there is no error
    m_sensor->setFault(SensorFault::LaserCircuitError, false);
    m_sensor->setFault(SensorFault::SystemError, true);
    QVERIFY(coil(51) && !coil(49) && coil(14) && !coil(13) && coil(12));
}

QTEST_GUILESS_MAIN(ManualModbusRegistersTest)
#include "tst_manual_modbus_registers.moc"

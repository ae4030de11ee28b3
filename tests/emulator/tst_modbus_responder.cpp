#include "manual_clock.h"
#include "modbus_responder.h"

#include <QTest>

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds;

namespace {

QByteArray hex(const char* text) { return QByteArray::fromHex(text); }

/// PDU of a multiple write from register `number`, as the manual prints it.
QByteArray writeMany(int number, const QList<quint16>& values)
{
    return modbus::encodeRequest(
        {modbus::Function::WriteMultipleRegisters, quint16(number - 400001), quint16(values.size()), values});
}
QByteArray writeOne(int number, quint16 value)
{
    return modbus::encodeRequest(
        {modbus::Function::WriteSingleRegister, quint16(number - 400001), 1, {value}});
}
QByteArray readMany(int number, int count)
{
    return modbus::encodeRequest(
        {modbus::Function::ReadHoldingRegisters, quint16(number - 400001), quint16(count), {}});
}

constexpr int accepted = 0;

} // namespace

class ModbusResponderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();

    // §5.2.2: which error code when
    void unsupportedFunctionsAreAFunctionCodeError();
    void lengthAndCountComeBeforeReadiness();
    void notReadyComesBeforeAddresses();

    // §5.2.3 reading
    void everyReadableItemReadsAsTheSensorHoldsIt();
    void unmappedProhibitedAndWriteOnlyRegistersReadAsZero();
    void readingOnlyUnreadableRegistersIsAnAddressError_data();
    void readingOnlyUnreadableRegistersIsAnAddressError();
    void oneHalfOfAFourByteItemCanBeRead();
    void theWholeTableCanBeReadInTwoMessages();
    void wordOrderIsLowWordFirstAndCanBeTurned();
    void coilsAreTheBitsOfTheStateRegisters();
    void coilsBeyondTheListReadAsZeroUnlessAllAre();

    // §5.2.3 single write
    void singleWriteToEachKindOfRegister_data();
    void singleWriteToEachKindOfRegister();
    void singleWriteEchoesTheRequest();

    // §5.2.3 multiple write
    void multipleWriteSkipsUnmappedAndReadOnlyRegisters();
    void multipleWriteOfNothingWritableIsAnAddressError();
    void multipleWriteTouchingAProhibitedAddressWritesNothing();
    void multipleWriteOfHalfAFourByteItemWritesNothing();
    void multipleWriteWithAnIllegalValueWritesNothing();
    void multipleWriteJudgesTheStateAllItsValuesMake();
    void multipleWriteThatFailsOnTheWayLeavesWhatCameBefore();
    void multipleWriteStoresNegativeFourByteValues();
    void oneByteRegistersTakeNoMoreThan255();

    void randomRequestsNeverBreakTheSensor();

private:
    int code(const QByteArray& request); ///< Error code of the answer; 0 for a normal one.
    QByteArray answer(const QByteArray& request) { return m_responder->answer(request); }
    Value now(ItemId id) { return m_sensor->read(id); }

    std::unique_ptr<ManualClock> m_clock;
    std::unique_ptr<VirtualSensor> m_sensor;
    std::unique_ptr<ModbusResponder> m_responder;
};

void ModbusResponderTest::init()
{
    m_responder.reset();
    m_sensor.reset();
    m_clock = std::make_unique<ManualClock>();
    m_sensor = std::make_unique<VirtualSensor>(SensorModel::HlG203, *m_clock);
    m_responder = std::make_unique<ModbusResponder>(*m_sensor);
}

int ModbusResponderTest::code(const QByteArray& request)
{
    const QByteArray reply = m_responder->answer(request);
    if (quint8(reply.at(0)) < 0x80)
        return accepted;
    [&] {
        QCOMPARE(reply.size(), 2);
        QCOMPARE(quint8(reply.at(0)), quint8(request.at(0) | 0x80));
    }();
    return quint8(reply.at(1));
}

void ModbusResponderTest::unsupportedFunctionsAreAFunctionCodeError()
{
    m_sensor->setInMenu(true); // comes before readiness
    for (const int function : {0x02, 0x04, 0x05, 0x0f, 0x16, 0x17, 0x2b})
        QCOMPARE(code(QByteArray(1, char(function)) + hex("00640001")), 1);
}

void ModbusResponderTest::lengthAndCountComeBeforeReadiness()
{
    m_sensor->setInMenu(true);
    QCOMPARE(code(hex("03 0064 0000")), 3);
    QCOMPARE(code(hex("03 0064 007e")), 3);
    QCOMPARE(code(hex("01 0000 07d1")), 3);
    QCOMPARE(code(hex("10 0064 0002 02 0001")), 3);
    QCOMPARE(code(hex("06 0064 0001 00")), 3);
}

void ModbusResponderTest::notReadyComesBeforeAddresses()
{
    m_sensor->setInMenu(true);
    QCOMPARE(code(readMany(400901, 1)), 4);
    QCOMPARE(code(readMany(400101, 2)), 4);
    QCOMPARE(code(hex("01 0000 0010")), 4);
    QCOMPARE(code(writeOne(400051, 0)), 4);
    QCOMPARE(code(writeMany(400109, {300})), 4);
    m_sensor->setInMenu(false);
    QCOMPARE(code(readMany(400901, 1)), 2);
    QCOMPARE(m_sensor->totalWriteCount(), 0);
}

void ModbusResponderTest::everyReadableItemReadsAsTheSensorHoldsIt()
{
    int seen = 0;
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (!item.modbus || !item.isReadable())
            continue;
        ++seen;
        const auto response =
            modbus::decodeResponse({modbus::Function::ReadHoldingRegisters,
                                    item.modbus->address(),
                                    quint16(item.registerCount()),
                                    {}},
                                   answer(readMany(item.modbus->number, item.registerCount())));
        QVERIFY2(response.has_value(), item.key);
        const QList<quint16>& words = response->registers;
        const Value value = words.size() == 2 ? modbus::toInt32(words[0], words[1], true) : words[0];
        QVERIFY2(value == m_sensor->read(item.id), item.key);
    }
    QVERIFY(seen > 50);
    QCOMPARE(answer(readMany(400101, 2)), hex("03 04 c350 0000")); // HIGH +5.0000 mm, low word first
    QCOMPARE(answer(readMany(400103, 2)), hex("03 04 3cb0 ffff")); // LOW −5.0000 mm
    QCOMPARE(answer(readMany(400155, 4)), hex("03 08 0006 0001 00a8 00c0"));
}

void ModbusResponderTest::unmappedProhibitedAndWriteOnlyRegistersReadAsZero()
{
    m_sensor->changeByKeypad(ItemId::KeyLock, 1);
    // 400107 is unmapped, 400108 key lock, 400109 eco mode.
    QCOMPARE(answer(readMany(400107, 3)), hex("03 06 0000 0001 0001"));
    // 400057 prohibited, 400058 bank, 400059 prohibited, 400060 write only.
    QCOMPARE(answer(readMany(400057, 4)), hex("03 08 0000 0001 0000 0000"));
}

void ModbusResponderTest::readingOnlyUnreadableRegistersIsAnAddressError_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("count");
    QTest::newRow("before the table") << 400001 << 10;
    QTest::newRow("write only") << 400054 << 1;
    QTest::newRow("prohibited") << 400051 << 1;
    QTest::newRow("prohibited and write only") << 400053 << 5;
    QTest::newRow("unmapped") << 400107 << 1;
    QTest::newRow("after the table") << 400171 << 100;
    QTest::newRow("the last address") << 465536 << 1;
    QTest::newRow("beyond the last address") << 465536 << 125;
}

void ModbusResponderTest::readingOnlyUnreadableRegistersIsAnAddressError()
{
    QFETCH(int, number);
    QFETCH(int, count);
    QCOMPARE(code(readMany(number, count)), 2);
}

void ModbusResponderTest::oneHalfOfAFourByteItemCanBeRead()
{
    QCOMPARE(answer(readMany(400103, 1)), hex("03 02 3cb0"));
    QCOMPARE(answer(readMany(400104, 1)), hex("03 02 ffff"));
    QCOMPARE(answer(readMany(400104, 2)), hex("03 04 ffff 0064")); // and the hysteresis's low word
}

void ModbusResponderTest::theWholeTableCanBeReadInTwoMessages()
{
    QCOMPARE(answer(readMany(400011, 125)).size(), 2 + 250);
    QCOMPARE(answer(readMany(400136, 36)).size(), 2 + 72);
}

void ModbusResponderTest::wordOrderIsLowWordFirstAndCanBeTurned()
{
    QCOMPARE(answer(readMany(400116, 2)), hex("03 04 2710 0000"));
    m_responder->setLowWordFirst(false);
    QCOMPARE(answer(readMany(400116, 2)), hex("03 04 0000 2710"));
    QCOMPARE(code(writeMany(400116, {1, 0x86a0})), 3); // 100,000
    QCOMPARE(code(writeMany(400116, {1, 0x869f})), accepted);
    QCOMPARE(now(ItemId::Span), 99'999);
}

void ModbusResponderTest::coilsAreTheBitsOfTheStateRegisters()
{
    m_sensor->placeWorkpiece(60'000);                          // outside the measurement range, above HIGH
    QCOMPARE(answer(hex("01 0000 0010")), hex("01 02 24 24")); // coils 3, 6, 11, 14
    QCOMPARE(answer(hex("01 0010 0004")), hex("01 01 04"));    // coil 19
    QCOMPARE(answer(readMany(400011, 4)), hex("03 08 2424 0004 0000 0000"));
    QCOMPARE(answer(hex("01 0002 0001")), hex("01 01 01"));
}

void ModbusResponderTest::coilsBeyondTheListReadAsZeroUnlessAllAre()
{
    m_sensor->setReservedBits(true);
    QCOMPARE(answer(hex("01 003f 0010")), hex("01 02 01 00")); // coil 64, reserved, exists
    QCOMPARE(answer(hex("01 0000 07d0")).size(), 2 + 250);
    QCOMPARE(code(hex("01 0040 0001")), 2);
    QCOMPARE(code(hex("01 ffff 07d0")), 2);
}

void ModbusResponderTest::singleWriteToEachKindOfRegister_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("expected");
    QTest::newRow("legal") << 400109 << 0 << accepted;
    QTest::newRow("two bytes") << 400110 << 65'535 << accepted;
    QTest::newRow("command") << 400054 << 0 << accepted;
    QTest::newRow("reserved command value") << 400054 << 1 << 3;
    QTest::newRow("out of range") << 400109 << 2 << 3;
    QTest::newRow("more than a byte") << 400109 << 256 << 3;
    QTest::newRow("unmapped") << 400107 << 0 << 2;
    QTest::newRow("prohibited") << 400053 << 0 << 2;
    QTest::newRow("read only") << 400129 << 0 << 2;
    QTest::newRow("read only of four bytes") << 400020 << 0 << 2;
    QTest::newRow("four bytes, first half") << 400101 << 0 << 3;
    QTest::newRow("four bytes, second half") << 400102 << 0 << 3;
    QTest::newRow("inconsistent") << 400153 << 49'152 << 3;
    QTest::newRow("start of a procedure") << 400136 << 1 << 0;
    QTest::newRow("point of a procedure that does not run") << 400138 << 0 << 4;
}

void ModbusResponderTest::singleWriteToEachKindOfRegister()
{
    QFETCH(int, number);
    QFETCH(int, value);
    QFETCH(int, expected);
    QCOMPARE(code(writeOne(number, quint16(value))), expected);
}

void ModbusResponderTest::singleWriteEchoesTheRequest()
{
    QCOMPARE(answer(writeOne(400110, 1'000)), hex("06 006d 03e8"));
    QCOMPARE(now(ItemId::AlarmDelayCount), 1'000);
}

void ModbusResponderTest::multipleWriteSkipsUnmappedAndReadOnlyRegisters()
{
    // 400107 unmapped, 400108 key lock, 400109 eco mode.
    QCOMPARE(answer(writeMany(400107, {0xffff, 1, 0})), hex("10 006a 0003"));
    QCOMPARE(now(ItemId::KeyLock), 1);
    QCOMPARE(now(ItemId::EcoMode), 0);
    QCOMPARE(m_sensor->totalWriteCount(), 2);
    // 400128 external trigger and 400129 hold state are read only.
    QCOMPARE(code(writeMany(400128, {0xffff, 0xffff, 1})), accepted);
    QCOMPARE(now(ItemId::TriggerMode), 1);
}

void ModbusResponderTest::multipleWriteOfNothingWritableIsAnAddressError()
{
    QCOMPARE(code(writeMany(400011, {0, 0, 0, 0, 0})), 2); // read only
    QCOMPARE(code(writeMany(400020, {0})), 2); // half of a read-only item is skipped like all of it
    QCOMPARE(code(writeMany(400107, {0})), 2);
    QCOMPARE(code(writeMany(465536, {0, 0, 0})), 2);
}

void ModbusResponderTest::multipleWriteTouchingAProhibitedAddressWritesNothing()
{
    QCOMPARE(code(writeMany(400052, {1, 0})), 2);
    QCOMPARE(now(ItemId::ZeroSetting), 0);
    QCOMPARE(code(writeMany(400126, {0, 0, 0, 0, 1})), 2); // 400127
    // Address before data: 400109 is out of range as well.
    QList<quint16> upTo127(19, 300);
    QCOMPARE(code(writeMany(400109, upTo127)), 2);
    QCOMPARE(m_sensor->totalWriteCount(), 0);
}

void ModbusResponderTest::multipleWriteOfHalfAFourByteItemWritesNothing()
{
    QCOMPARE(code(writeMany(400101, {1})), 3);
    QCOMPARE(code(writeMany(400102, {0})), 3);
    QCOMPARE(code(writeMany(400102, {0, 0})), 3);
    QCOMPARE(code(writeMany(400102, {0, 0, 0})), 3);
    QCOMPARE(code(writeMany(400115, {0, 10'000})), 3); // hold mode, then half of the span
    QCOMPARE(m_sensor->totalWriteCount(), 0);
}

void ModbusResponderTest::multipleWriteWithAnIllegalValueWritesNothing()
{
    QCOMPARE(code(writeMany(400108, {1, 0, 100, 4})), 3); // display digit 4 is none of this type
    QCOMPARE(now(ItemId::KeyLock), 0);
    QCOMPARE(now(ItemId::AlarmDelayCount), 8);
    QCOMPARE(m_sensor->totalWriteCount(), 0);
}

void ModbusResponderTest::multipleWriteJudgesTheStateAllItsValuesMake()
{
    const auto window = [](qint32 high, qint32 low) {
        return modbus::fromInt32(high, true) + modbus::fromInt32(low, true);
    };
    QCOMPARE(code(writeMany(400103, modbus::fromInt32(60'000, true))), 3); // LOW alone would pass HIGH
    QCOMPARE(code(writeMany(400101, window(70'000, 60'000))), accepted);
    QCOMPARE(now(ItemId::HighSetValue), 70'000);
    QCOMPARE(now(ItemId::LowSetValue), 60'000);
    QCOMPARE(code(writeMany(400101, window(60'100, 60'000))), 3); // within twice the hysteresis
    QCOMPARE(code(writeMany(400101, window(60'201, 60'000))), accepted);
    // Address and gateway into another network in one message (§5.1.1).
    QCOMPARE(code(writeMany(400157, {5})), 3);
    QCOMPARE(code(writeMany(400155, {6, 1, 5, 10, 0, 255, 255, 255, 1, 1, 5, 10})), accepted);
    QCOMPARE(now(ItemId::IpAddress1stOctet), 10);
}

void ModbusResponderTest::multipleWriteThatFailsOnTheWayLeavesWhatCameBefore()
{
    m_sensor->setWriteFailure(ItemId::AlarmDelayCount, true);
    QCOMPARE(code(writeMany(400109, {0, 100, 1})), 4);
    QCOMPARE(now(ItemId::EcoMode), 0);
    QCOMPARE(now(ItemId::AlarmDelayCount), 8);
    QCOMPARE(now(ItemId::DisplayDigit), 0);
}

void ModbusResponderTest::multipleWriteStoresNegativeFourByteValues()
{
    QCOMPARE(code(writeMany(400118, {0x8d08, 0xfffe})), accepted);
    QCOMPARE(now(ItemId::Offset), -94'968);                 // 0xfffe8d08
    QCOMPARE(code(writeMany(400118, {0x8ce7, 0xfffe})), 3); // −95,001
}

void ModbusResponderTest::oneByteRegistersTakeNoMoreThan255()
{
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (!item.modbus || !item.isWritable() || item.size != 1)
            continue;
        const auto legal = quint16(item.limitsFor(SensorModel::HlG203).minimum);
        QVERIFY2(code(writeOne(item.modbus->number, 0x100 | legal)) == 3, item.key);
        QVERIFY2(code(writeMany(item.modbus->number, {quint16(0x100 | legal)})) == 3, item.key);
    }
    QCOMPARE(m_sensor->totalWriteCount(), 0);
}

void ModbusResponderTest::randomRequestsNeverBreakTheSensor()
{
    std::srand(99);
    const auto random = [](int bound) { return std::rand() % bound; };
    int normal = 0;
    for (int round = 0; round < 20'000; ++round) {
        const int start = 400001 + random(180);
        QByteArray request;
        switch (random(4)) {
        case 0:
            request = readMany(start, 1 + random(125));
            break;
        case 1:
            request = writeOne(start, quint16(random(8)));
            break;
        case 2: {
            QList<quint16> values;
            for (int i = random(6); i >= 0; --i)
                values.append(quint16(random(3) ? random(6) : random(65'536)));
            request = writeMany(start, values);
            break;
        }
        default:
            for (int i = random(260); i >= 0; --i)
                request.append(char(random(256)));
        }
        m_clock->advanceMs(1);
        const QByteArray reply = m_responder->answer(request);
        QVERIFY(reply.size() >= 2 && reply.size() <= 253);
        normal += quint8(reply.at(0)) < 0x80;
        for (int bank = 0; bank < SettingsMemory::bankCount; ++bank) {
            const auto judged = judgeStored(m_sensor->memory(), bank);
            QVERIFY2(judged.has_value(), judged ? "" : qPrintable(judged.error().reason));
        }
    }
    QVERIFY(normal > 5'000);
}

QTEST_GUILESS_MAIN(ModbusResponderTest)
#include "tst_modbus_responder.moc"

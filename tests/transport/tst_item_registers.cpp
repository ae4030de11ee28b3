#include "item_registers.h"

#include <QTest>

using namespace lds;
using namespace lds::modbus;
using catalog::ItemId;

namespace {

QList<ItemId> everyItem()
{
    QList<ItemId> items;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items())
        items.append(item.id);
    return items;
}

QList<quint16> zeros(const RegisterRange& range) { return QList<quint16>(range.count, 0); }

/// The registers of the measurement poll, 400011–400022.
QList<quint16> poll(const QMap<int, quint16>& set)
{
    QList<quint16> registers(12, 0);
    for (auto it = set.cbegin(); it != set.cend(); ++it)
        registers[it.key() - 400011] = it.value();
    return registers;
}

} // namespace

class ItemRegistersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everythingReadableTakesTwoReads();
    void readsCoverEveryReadableItemAndStayWithinTheLimit();
    void neighboursShareARead();
    void readReachesAsFarAsOneMessageMay();
    void halfAnItemGivesNoValue();
    void itemsThatCannotBeReadTakeNoRead();
    void writeOnlyItemsNeverGetAValue();
    void valuesKeepTheirSignAndWidth();
    void reservedBitsAreMasked();
    void registersOfAnotherSizeGiveNothing();
    void oneRegisterGoesOutByFunction06();
    void fourByteItemGoesOutByFunction10();
    void octetsGoOutInOneMessageInTheOrderOfTheirRegisters();
    void whatCannotGoOutIsRefused_data();
    void whatCannotGoOutIsRefused();
    void measurementPollIsOneRead();
    void measurementIsDecoded();
    void sentinelsAreNoValues_data();
    void sentinelsAreNoValues();
    void intensityThatCannotBeIsNone();
    void spanDecidesTheWordOrder_data();
    void spanDecidesTheWordOrder();
};

void ItemRegistersTest::everythingReadableTakesTwoReads()
{
    const QList<RegisterRange> ranges = packReads(everyItem());
    QCOMPARE(ranges.size(), 2);
    QCOMPARE(printedRegister(ranges.at(0).first), 400011);
    QCOMPARE(printedRegister(ranges.at(1).end() - 1), 400170); // 400171 is write only
}

void ItemRegistersTest::readsCoverEveryReadableItemAndStayWithinTheLimit()
{
    settings::Values values;
    for (const RegisterRange& range : packReads(everyItem())) {
        QVERIFY(range.count >= 1 && range.count <= 125);
        values.insert(decodeItems(everyItem(), range, zeros(range), true));
    }
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items())
        QVERIFY2(values.contains(item.id) == (item.modbus && item.isReadable()), item.key);
}

void ItemRegistersTest::neighboursShareARead()
{
    QCOMPARE(packReads({ItemId::LowSetValue, ItemId::HighSetValue, ItemId::HighSetValue}),
             (QList<RegisterRange>{{100, 4}}));
    QCOMPARE(packReads({ItemId::TerminationResistance}), (QList<RegisterRange>{{169, 1}}));
}

void ItemRegistersTest::readReachesAsFarAsOneMessageMay()
{
    // 400020–400144 are 125 registers, one more is too many.
    QCOMPARE(packReads({ItemId::MeasuredValue, ItemId::BrightnessTuningExecutionState}),
             (QList<RegisterRange>{{19, 125}}));
    QCOMPARE(packReads({ItemId::BrightnessTuningExecutionState, ItemId::ErrorCode}),
             (QList<RegisterRange>{{14, 1}, {143, 1}}));
}

void ItemRegistersTest::halfAnItemGivesNoValue()
{
    QVERIFY(decodeItems({ItemId::HighSetValue}, {100, 1}, {5}, true).isEmpty());
    QVERIFY(decodeItems({ItemId::HighSetValue}, {101, 1}, {5}, true).isEmpty());
    QCOMPARE(decodeItems({ItemId::HighSetValue}, {100, 2}, {5, 0}, true).value(ItemId::HighSetValue), 5);
}

void ItemRegistersTest::itemsThatCannotBeReadTakeNoRead()
{
    QVERIFY(packReads({}).isEmpty());
    QVERIFY(packReads({ItemId::SetValueSaving, ItemId::PortSlmp}).isEmpty());
}

void ItemRegistersTest::writeOnlyItemsNeverGetAValue()
{
    const RegisterRange range{quint16(400051 - 400001), 20};
    const settings::Values values =
        decodeItems({ItemId::ZeroSetting, ItemId::SetValueSaving, ItemId::BankSwitching, ItemId::BankCopy},
                    range, zeros(range), true);
    QCOMPARE(values.keys(), (QList<ItemId>{ItemId::ZeroSetting, ItemId::BankSwitching}));
}

void ItemRegistersTest::valuesKeepTheirSignAndWidth()
{
    const RegisterRange range{100, 14}; // 400101–400114
    QList<quint16> registers = zeros(range);
    registers[0] = 0x8ce8; // HIGH −95,000 = FFFE 8CE8: low word first …
    registers[1] = 0xfffe;
    registers[9] = 0xffff; // 400110: 2 bytes, unsigned
    const QList<ItemId> items{ItemId::HighSetValue, ItemId::AlarmDelayCount};
    settings::Values values = decodeItems(items, range, registers, true);
    QCOMPARE(values.value(ItemId::HighSetValue), -95'000);
    QCOMPARE(values.value(ItemId::AlarmDelayCount), 65'535);
    std::swap(registers[0], registers[1]); // … and high word first.
    values = decodeItems(items, range, registers, false);
    QCOMPARE(values.value(ItemId::HighSetValue), -95'000);
}

void ItemRegistersTest::reservedBitsAreMasked()
{
    const RegisterRange range{10, 4};
    const settings::Values values = decodeItems({ItemId::SensorState, ItemId::SelfMonitoringNotification,
                                                 ItemId::SelfMonitoringCaution, ItemId::SelfMonitoringError},
                                                range, {0xffff, 0xffff, 0xffff, 0xffff}, true);
    // §5.2.5: coils 15–16, 21–32, 35–48, 50 and 52–64 are reserved.
    QCOMPARE(values.value(ItemId::SensorState), 0x3fff);
    QCOMPARE(values.value(ItemId::SelfMonitoringNotification), 0x000f);
    QCOMPARE(values.value(ItemId::SelfMonitoringCaution), 0x0003);
    QCOMPARE(values.value(ItemId::SelfMonitoringError), 0x0005);
}

void ItemRegistersTest::registersOfAnotherSizeGiveNothing()
{
    QVERIFY(decodeItems({ItemId::HighSetValue}, {100, 2}, {1}, true).isEmpty());
}

void ItemRegistersTest::oneRegisterGoesOutByFunction06()
{
    const auto request = encodeWrite({{ItemId::OutputDelayTimerSetting, 100}}, true);
    QVERIFY(request);
    QCOMPARE(encodeRequest(*request), QByteArray::fromHex("06 007a 0064")); // 400123
}

void ItemRegistersTest::fourByteItemGoesOutByFunction10()
{
    const settings::Write write{{ItemId::LowSetValue, -95'000}}; // 400103; FFFE 8CE8
    QCOMPARE(encodeRequest(*encodeWrite(write, true)), QByteArray::fromHex("10 0066 0002 04 8ce8 fffe"));
    QCOMPARE(encodeRequest(*encodeWrite(write, false)), QByteArray::fromHex("10 0066 0002 04 fffe 8ce8"));
}

void ItemRegistersTest::octetsGoOutInOneMessageInTheOrderOfTheirRegisters()
{
    const auto request = encodeWrite({{ItemId::IpAddress1stOctet, 192},
                                      {ItemId::IpAddress2ndOctet, 168},
                                      {ItemId::IpAddress3rdOctet, 1},
                                      {ItemId::IpAddress4thOctet, 6}},
                                     true);
    QVERIFY(request);
    // 400155 is the 4th octet (§5.2.4).
    QCOMPARE(encodeRequest(*request), QByteArray::fromHex("10 009a 0004 08 0006 0001 00a8 00c0"));
}

void ItemRegistersTest::whatCannotGoOutIsRefused_data()
{
    QTest::addColumn<settings::Write>("write");
    QTest::addColumn<ports::FailureCode>("code");
    using ports::FailureCode;
    QTest::newRow("nothing") << settings::Write{} << FailureCode::OtherRefusal;
    QTest::newRow("no register") << settings::Write{{ItemId::PortSlmp, 1}} << FailureCode::NotReachable;
    QTest::newRow("read only") << settings::Write{{ItemId::MeasuredValue, 1}} << FailureCode::AddressRefused;
    QTest::newRow("two settings") << settings::Write{{ItemId::HighSetValue, 1}, {ItemId::LowSetValue, 0}}
                                  << FailureCode::OtherRefusal;
    QTest::newRow("two groups") << settings::Write{{ItemId::IpAddress1stOctet, 1},
                                                   {ItemId::SubnetMask4thOctet, 0}}
                                << FailureCode::OtherRefusal;
    QTest::newRow("a gap") << settings::Write{{ItemId::IpAddress1stOctet, 1}, {ItemId::IpAddress4thOctet, 0}}
                           << FailureCode::OtherRefusal;
    QTest::newRow("twice") << settings::Write{{ItemId::IpAddress1stOctet, 1}, {ItemId::IpAddress1stOctet, 2}}
                           << FailureCode::OtherRefusal;
    QTest::newRow("negative") << settings::Write{{ItemId::KeyLock, -1}} << FailureCode::ValueRefused;
    QTest::newRow("over one byte") << settings::Write{{ItemId::KeyLock, 256}} << FailureCode::ValueRefused;
    QTest::newRow("over two bytes") << settings::Write{{ItemId::AlarmDelayCount, 65'536}}
                                    << FailureCode::ValueRefused;
}

void ItemRegistersTest::whatCannotGoOutIsRefused()
{
    QFETCH(settings::Write, write);
    QFETCH(ports::FailureCode, code);
    const auto request = encodeWrite(write, true);
    QVERIFY(!request);
    QCOMPARE(request.error().code, code);
    QCOMPARE(request.error().wireCode, 0);
}

void ItemRegistersTest::measurementPollIsOneRead()
{
    QCOMPARE(printedRegister(measurementRange().first), 400011);
    QCOMPARE(printedRegister(measurementRange().end() - 1), 400022);
}

void ItemRegistersTest::measurementIsDecoded()
{
    const QList<quint16> registers = poll({{400011, 0xc408},
                                           {400012, 0xfff5},
                                           {400013, 0xfffe},
                                           {400014, 0xfffa},
                                           {400015, 0x0100},
                                           {400020, 0xcfc7}, // −12,345
                                           {400021, 0xffff},
                                           {400022, 512}});
    const measurement::Measurement sample = decodeMeasurement(registers, true);
    QCOMPARE(sample.value, -12'345);
    QCOMPARE(sample.kind, measurement::ValueKind::Valid);
    QCOMPARE(sample.state, quint16(measurement::LaserBit | measurement::GoBit));
    QCOMPARE(sample.notification, quint16(0x5));
    QCOMPARE(sample.caution, quint16(0x2));
    QCOMPARE(sample.error, quint16(0x0));
    QCOMPARE(sample.errorCode, quint16(0x0100));
    QCOMPARE(sample.intensity, quint16(512));
}

void ItemRegistersTest::sentinelsAreNoValues_data()
{
    QTest::addColumn<qint32>("value");
    QTest::addColumn<measurement::ValueKind>("kind");
    using measurement::ValueKind;
    QTest::newRow("over") << 9'600'000 << ValueKind::Over;
    QTest::newRow("under") << -9'600'000 << ValueKind::Under;
    QTest::newRow("indeterminate") << -9'999'999 << ValueKind::Indeterminate;
    QTest::newRow("alarm") << 9'999'999 << ValueKind::Alarm;
    QTest::newRow("a value") << 9'500'000 << ValueKind::Valid;
}

void ItemRegistersTest::sentinelsAreNoValues()
{
    QFETCH(qint32, value);
    QFETCH(measurement::ValueKind, kind);
    for (const bool lowWordFirst : {true, false}) {
        const auto low = quint16(quint32(value) & 0xffff);
        const auto high = quint16(quint32(value) >> 16);
        const QList<quint16> registers = poll(
            {{400020, lowWordFirst ? low : high}, {400021, lowWordFirst ? high : low}, {400022, 65'535}});
        QCOMPARE(decodeMeasurement(registers, lowWordFirst).value, value);
        QCOMPARE(decodeMeasurement(registers, lowWordFirst).kind, kind);
    }
}

void ItemRegistersTest::intensityThatCannotBeIsNone()
{
    QCOMPARE(decodeMeasurement(poll({{400022, 1023}}), true).intensity, quint16(1023));
    QCOMPARE(decodeMeasurement(poll({{400022, 1024}}), true).intensity, quint16(65'535));
}

void ItemRegistersTest::spanDecidesTheWordOrder_data()
{
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("second");
    QTest::addColumn<int>("lowWordFirst"); // −1: no HL-G2
    QTest::newRow("1.0000, low first") << 10'000 << 0 << 1;
    QTest::newRow("1.0000, high first") << 0 << 10'000 << 0;
    QTest::newRow("0.1000, low first") << 1000 << 0 << 1;
    QTest::newRow("0.1000, high first") << 0 << 1000 << 0;
    QTest::newRow("9.9999, low first") << 0x869f << 1 << 1;
    QTest::newRow("9.9999, high first") << 1 << 0x869f << 0;
    QTest::newRow("6.5536, low first") << 0 << 1 << 1;
    QTest::newRow("6.5536, high first") << 1 << 0 << 0;
    QTest::newRow("6.5537, equal words") << 1 << 1 << 1;
    QTest::newRow("0.0999") << 999 << 0 << -1;
    QTest::newRow("10.0000") << 0x86a0 << 1 << -1;
    QTest::newRow("zeros") << 0 << 0 << -1;
    QTest::newRow("ones") << 0xffff << 0xffff << -1;
}

void ItemRegistersTest::spanDecidesTheWordOrder()
{
    QFETCH(int, first);
    QFETCH(int, second);
    QFETCH(int, lowWordFirst);
    const auto found = lowWordFirstBySpan(quint16(first), quint16(second));
    QCOMPARE(found.has_value(), lowWordFirst >= 0);
    if (found)
        QCOMPARE(*found, lowWordFirst == 1);
}

QTEST_GUILESS_MAIN(ItemRegistersTest)
#include "tst_item_registers.moc"

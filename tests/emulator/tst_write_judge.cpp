#include "write_judge.h"

#include <QTest>

using namespace lds::emulator;
using namespace lds::catalog;

namespace {

using Writes = QList<ItemWrite>;
constexpr int refused = INT_MIN; ///< In a table of values: the write is a data error.

bool accepts(const SettingsMemory& memory, const Writes& writes)
{
    return judgeWrites(memory, writes).has_value();
}

} // namespace

class WriteJudgeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void slmpPortAndStationAreJudgedAtTheKeys_data();
    void slmpPortAndStationAreJudgedAtTheKeys();
    void valuesAreJudgedByTheRangeAndResolutionOfTheModel_data();
    void valuesAreJudgedByTheRangeAndResolutionOfTheModel();
    void highHasToBeAboveLowByMoreThanTwiceTheHysteresis();
    void highAndLowMayMoveTogetherInOneMessage();
    void theWindowIsJudgedOfTheRoundedValues();
    void toleranceHasToBeAboveTheHysteresisWhenItIsWritten();
    void oneShotNeedsHoldModeNone();
    void aHoldModeIsAcceptedWhateverTheTriggerMode();
    void portsCannotBe44818OrTheSame();
    void theAddressIsJudgedAsACombination();
    void oneIllegalValueRefusesTheWholeMessage();
    void conditionsOfItemsNotWrittenAreNotJudged();
    void theBankInUseIsJudged();
};

void WriteJudgeTest::valuesAreJudgedByTheRangeAndResolutionOfTheModel_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("item");
    QTest::addColumn<int>("written");
    QTest::addColumn<int>("stored");

    const auto row = [](const char* name, SensorModel model, ItemId item, int written, int stored) {
        QTest::newRow(name) << int(model) << int(item) << written << stored;
    };
    using enum SensorModel;
    row("203 offset maximum", HlG203, ItemId::Offset, 95'000, 95'000);
    row("203 offset above", HlG203, ItemId::Offset, 95'001, refused);
    row("203 offset minimum", HlG203, ItemId::Offset, -95'000, -95'000);
    row("203 offset below", HlG203, ItemId::Offset, -95'001, refused);
    row("203 keeps 0.1 um", HlG203, ItemId::Offset, 12'345, 12'345);
    row("205 offset maximum", HlG205, ItemId::Offset, 950'000, 950'000);
    row("205 rounds to 1 um", HlG205, ItemId::Offset, 12'349, 12'340);
    row("208 rounds towards zero", HlG208, ItemId::Offset, -12'349, -12'340);
    row("212 offset above", HlG212, ItemId::Offset, 950'001, refused);
    row("225 offset maximum", HlG225, ItemId::Offset, 9'500'000, 9'500'000);
    row("225 rounds to 10 um", HlG225, ItemId::Offset, -1'299, -1'200);
    row("203 smallest tolerance", HlG203, ItemId::Tolerance, 0, refused);
    row("205 tolerance below its minimum", HlG205, ItemId::Tolerance, 9, refused);
    row("225 tolerance below its minimum", HlG225, ItemId::Tolerance, 99, refused);
    row("hysteresis zero", HlG203, ItemId::Hysteresis, 0, 0);
    row("hysteresis negative", HlG203, ItemId::Hysteresis, -1, refused);
    row("span minimum", HlG203, ItemId::Span, 1'000, 1'000);
    row("span below", HlG203, ItemId::Span, 999, refused);
    row("span maximum", HlG203, ItemId::Span, 99'999, 99'999);
    row("span above", HlG203, ItemId::Span, 100'000, refused);
    row("timer minimum", HlG203, ItemId::OutputDelayTimerSetting, 1, 1);
    row("timer zero", HlG203, ItemId::OutputDelayTimerSetting, 0, refused);
    row("timer maximum", HlG203, ItemId::OutputDelayTimerSetting, 100, 100);
    row("timer above", HlG203, ItemId::OutputDelayTimerSetting, 101, refused);
    row("alarm delay 0", HlG203, ItemId::AlarmDelayCount, 0, 0);
    row("alarm delay maximum", HlG203, ItemId::AlarmDelayCount, 65'535, 65'535);
    row("average 1024", HlG203, ItemId::AverageTimes, 6, 6);
    row("average unknown", HlG203, ItemId::AverageTimes, 7, refused);
    row("sampling 2 ms", HlG203, ItemId::SamplingFrequency, 4, 4);
    row("sampling unknown", HlG203, ItemId::SamplingFrequency, 5, refused);
    row("hold peak to peak", HlG203, ItemId::HoldMode, 3, 3);
    row("hold unknown", HlG203, ItemId::HoldMode, 4, refused);
    row("203 four digits", HlG203, ItemId::DisplayDigit, 0, 0);
    row("203 no digit", HlG203, ItemId::DisplayDigit, 4, refused);
    row("205 four digits", HlG205, ItemId::DisplayDigit, 0, refused);
    row("205 no digit", HlG205, ItemId::DisplayDigit, 4, 4);
    row("225 three digits", HlG225, ItemId::DisplayDigit, 1, refused);
    row("225 two digits", HlG225, ItemId::DisplayDigit, 2, 2);
    row("teaching mode 0", HlG203, ItemId::TeachingMode, 0, refused);
    row("teaching mode 3", HlG203, ItemId::TeachingMode, 3, 3);
    row("language", HlG203, ItemId::LanguageSetting, 3, refused);
    row("device address 0", HlG203, ItemId::DeviceAddress, 0, refused);
    row("device address 247", HlG203, ItemId::DeviceAddress, 247, 247);
    row("device address 248", HlG203, ItemId::DeviceAddress, 248, refused);
    row("save executes", HlG203, ItemId::SetValueSaving, 0, 0);
    row("save reserved", HlG203, ItemId::SetValueSaving, 1, refused);
    row("reset reserved", HlG203, ItemId::MeasuredValueResetting, 255, refused);
    row("communication reset reserved", HlG203, ItemId::ResettingCommunicationSettings, 1, refused);
    row("teaching point reserved", HlG203, ItemId::Teaching1stPoint, 1, refused);
    row("bank 0", HlG203, ItemId::BankSwitching, 0, refused);
    row("bank 4", HlG203, ItemId::BankSwitching, 4, 4);
    row("bank 5", HlG203, ItemId::BankSwitching, 5, refused);
    row("bank copy 11", HlG203, ItemId::BankCopy, 11, 11);
    row("bank copy 12", HlG203, ItemId::BankCopy, 12, refused);
    row("initialize 0", HlG203, ItemId::SettingsInitialization, 0, refused);
    row("initialize 6", HlG203, ItemId::SettingsInitialization, 6, 6);
    row("initialize 7", HlG203, ItemId::SettingsInitialization, 7, refused);
    row("zero setting 2", HlG203, ItemId::ZeroSetting, 2, refused);
}

void WriteJudgeTest::valuesAreJudgedByTheRangeAndResolutionOfTheModel()
{
    QFETCH(int, model);
    QFETCH(int, item);
    QFETCH(int, written);
    QFETCH(int, stored);
    const auto judged = judgeWrites(SettingsMemory(SensorModel(model)), {{ItemId(item), written}});
    QCOMPARE(judged.has_value(), stored != refused);
    if (judged)
        QCOMPARE(*judged, (Writes{{ItemId(item), stored}}));
    else
        QCOMPARE(judged.error().item, ItemId(item));
}

void WriteJudgeTest::highHasToBeAboveLowByMoreThanTwiceTheHysteresis()
{
    SettingsMemory memory(SensorModel::HlG203); // ±50,000, hysteresis 100
    QVERIFY(!accepts(memory, {{ItemId::HighSetValue, -50'000}}));
    QVERIFY(!accepts(memory, {{ItemId::HighSetValue, -49'800}})); // exactly twice
    QVERIFY(accepts(memory, {{ItemId::HighSetValue, -49'799}}));
    QVERIFY(!accepts(memory, {{ItemId::LowSetValue, 49'800}}));
    QVERIFY(accepts(memory, {{ItemId::LowSetValue, 49'799}}));
    QVERIFY(!accepts(memory, {{ItemId::Hysteresis, 50'000}}));
    QVERIFY(accepts(memory, {{ItemId::Hysteresis, 49'999}}));
    memory.setValue(ItemId::Hysteresis, 0);
    QVERIFY(!accepts(memory, {{ItemId::HighSetValue, -50'000}})); // equal is not above
    QVERIFY(accepts(memory, {{ItemId::HighSetValue, -49'999}}));
}

void WriteJudgeTest::highAndLowMayMoveTogetherInOneMessage()
{
    const SettingsMemory memory(SensorModel::HlG203);
    QVERIFY(!accepts(memory, {{ItemId::LowSetValue, 60'000}})); // alone it would stand above HIGH
    QVERIFY(accepts(memory, {{ItemId::HighSetValue, 70'000}, {ItemId::LowSetValue, 60'000}}));
    QVERIFY(!accepts(memory, {{ItemId::HighSetValue, 60'000}, {ItemId::LowSetValue, 70'000}}));
    QVERIFY(accepts(
        memory, {{ItemId::HighSetValue, 60'200}, {ItemId::LowSetValue, 60'000}, {ItemId::Hysteresis, 99}}));
}

void WriteJudgeTest::theWindowIsJudgedOfTheRoundedValues()
{
    SettingsMemory memory(SensorModel::HlG225); // resolution 100
    memory.setValue(ItemId::Hysteresis, 0);
    QVERIFY(!accepts(memory, {{ItemId::HighSetValue, 199}, {ItemId::LowSetValue, 100}})); // both become 100
    QVERIFY(!accepts(memory, {{ItemId::HighSetValue, 99}, {ItemId::LowSetValue, -99}}));  // both become 0
    QVERIFY(accepts(memory, {{ItemId::HighSetValue, 200}, {ItemId::LowSetValue, 100}}));
}

void WriteJudgeTest::toleranceHasToBeAboveTheHysteresisWhenItIsWritten()
{
    const SettingsMemory memory(SensorModel::HlG203); // hysteresis 100, tolerance 20,000
    QVERIFY(!accepts(memory, {{ItemId::Tolerance, 100}}));
    QVERIFY(accepts(memory, {{ItemId::Tolerance, 101}}));
    QVERIFY(accepts(memory, {{ItemId::Hysteresis, 30'000}})); // §4.4.5: regardless of the tolerance
    QVERIFY(!accepts(memory, {{ItemId::Hysteresis, 30'000}, {ItemId::Tolerance, 30'000}}));
    QVERIFY(accepts(memory, {{ItemId::Hysteresis, 50}, {ItemId::Tolerance, 51}}));
}

void WriteJudgeTest::oneShotNeedsHoldModeNone()
{
    SettingsMemory memory(SensorModel::HlG203);
    QVERIFY(accepts(memory, {{ItemId::TriggerMode, 1}}));
    QVERIFY(!accepts(memory, {{ItemId::HoldMode, 1}, {ItemId::TriggerMode, 1}}));
    memory.setValue(ItemId::HoldMode, 2);
    QVERIFY(!accepts(memory, {{ItemId::TriggerMode, 1}}));
    QVERIFY(accepts(memory, {{ItemId::TriggerMode, 0}}));
    QVERIFY(accepts(memory, {{ItemId::HoldMode, 0}, {ItemId::TriggerMode, 1}}));
}

void WriteJudgeTest::aHoldModeIsAcceptedWhateverTheTriggerMode()
{
    SettingsMemory memory(SensorModel::HlG203);
    memory.setValue(ItemId::TriggerMode, 1); // the sensor turns it into Hold by itself (§4.3.4)
    for (const Value mode : {0, 1, 2, 3})
        QVERIFY(accepts(memory, {{ItemId::HoldMode, mode}}));
}

void WriteJudgeTest::portsCannotBe44818OrTheSame()
{
    const SettingsMemory memory(SensorModel::HlG203); // 502 and 49152
    QVERIFY(accepts(memory, {{ItemId::PortModbus, 1}}));
    QVERIFY(accepts(memory, {{ItemId::PortModbus, 65'535}}));
    QVERIFY(!accepts(memory, {{ItemId::PortModbus, 0}}));
    QVERIFY(!accepts(memory, {{ItemId::PortModbus, 44'818}}));
    QVERIFY(!accepts(memory, {{ItemId::PortTool, 44'818}}));
    QVERIFY(!accepts(memory, {{ItemId::PortModbus, 49'152}}));
    QVERIFY(!accepts(memory, {{ItemId::PortTool, 502}}));
    QVERIFY(accepts(memory, {{ItemId::PortModbus, 49'152}, {ItemId::PortTool, 502}}));
}

void WriteJudgeTest::theAddressIsJudgedAsACombination()
{
    const SettingsMemory memory(SensorModel::HlG203); // 192.168.1.6, gateway 192.168.1.1
    QVERIFY(accepts(memory, {{ItemId::IpAddress4thOctet, 7}}));
    QVERIFY(!accepts(memory, {{ItemId::IpAddress4thOctet, 256}}));
    QVERIFY(!accepts(memory, {{ItemId::IpAddress4thOctet, 255}}));
    QVERIFY(!accepts(memory, {{ItemId::IpAddress3rdOctet, 2}})); // the gateway is elsewhere then
    const Writes noGateway{{ItemId::DefaultGateway4thOctet, 0},
                           {ItemId::DefaultGateway3rdOctet, 0},
                           {ItemId::DefaultGateway2ndOctet, 0},
                           {ItemId::DefaultGateway1stOctet, 0}};
    QVERIFY(accepts(memory, noGateway));
    QVERIFY(accepts(memory, Writes{{ItemId::IpAddress3rdOctet, 2}} + noGateway));
    QVERIFY(accepts(memory, {{ItemId::IpAddress3rdOctet, 2}, {ItemId::DefaultGateway3rdOctet, 2}}));
    QVERIFY(!accepts(memory, {{ItemId::SubnetMask2ndOctet, 0}}));
    QVERIFY(accepts(memory, {{ItemId::SubnetMask3rdOctet, 0}}));
}

void WriteJudgeTest::oneIllegalValueRefusesTheWholeMessage()
{
    const SettingsMemory memory(SensorModel::HlG203);
    const auto judged =
        judgeWrites(memory, {{ItemId::EcoMode, 0}, {ItemId::AlarmDelayCount, 3}, {ItemId::DisplayDigit, 9}});
    QVERIFY(!judged.has_value());
    QCOMPARE(judged.error().item, ItemId::DisplayDigit);
}

void WriteJudgeTest::conditionsOfItemsNotWrittenAreNotJudged()
{
    SettingsMemory memory(SensorModel::HlG203); // a state that no message could have made
    memory.setValue(ItemId::HighSetValue, -60'000);
    memory.setValue(ItemId::PortTool, 502);
    memory.setValue(ItemId::SubnetMask1stOctet, 0);
    QVERIFY(accepts(memory, {{ItemId::EcoMode, 0}}));
    QVERIFY(accepts(memory, {{ItemId::Tolerance, 500}}));
    QVERIFY(!accepts(memory, {{ItemId::Hysteresis, 0}}));
    QVERIFY(accepts(memory, {{ItemId::HighSetValue, 0}}));
}

void WriteJudgeTest::theBankInUseIsJudged()
{
    SettingsMemory memory(SensorModel::HlG203);
    memory.setValue(ItemId::LowSetValue, 10'000, 1);
    QVERIFY(accepts(memory, {{ItemId::HighSetValue, 0}}));
    memory.setValue(ItemId::BankSwitching, 2);
    QVERIFY(!accepts(memory, {{ItemId::HighSetValue, 0}}));
}

void WriteJudgeTest::slmpPortAndStationAreJudgedAtTheKeys_data() // §5.4.1 notes 4, 6 and 7
{
    QTest::addColumn<QList<ItemWrite>>("writes");
    QTest::addColumn<bool>("legal");
    for (const auto& [port, legal] :
         {std::pair{2222, false}, {9090, false}, {44818, false}, {45237, true}, {1, true}})
        QTest::addRow("port %d", port) << QList<ItemWrite>{{ItemId::PortSlmp, port}} << legal;
    struct Station {
        int network;
        int node;
        bool legal;
    };
    for (const Station& station : {Station{0, 255, true},
                                   {0, 1, false},
                                   {1, 255, false},
                                   {1, 1, true},
                                   {239, 120, true},
                                   {1, 121, false},
                                   {1, 124, false},
                                   {1, 125, true},
                                   {1, 126, true},
                                   {1, 127, false},
                                   {240, 1, false}})
        QTest::addRow("%d/%d", station.network, station.node)
            << QList<ItemWrite>{{ItemId::NetworkNumber, station.network}, {ItemId::NodeNumber, station.node}}
            << station.legal;
}

void WriteJudgeTest::slmpPortAndStationAreJudgedAtTheKeys()
{
    QFETCH(QList<ItemWrite>, writes);
    QFETCH(bool, legal);
    QCOMPARE(judgeWrites(SettingsMemory(SensorModel::HlG203), writes).has_value(), legal);
}

QTEST_APPLESS_MAIN(WriteJudgeTest)
#include "tst_write_judge.moc"

#include "settings_memory.h"

#include <algorithm>
#include <QTest>

using namespace lds::emulator;
using namespace lds::catalog;

namespace {

/// §4.2 "Types of setting items read from banks", as the manual lists them.
constexpr ItemId banked[] = {ItemId::SamplingFrequency,
                             ItemId::AverageTimes,
                             ItemId::BrightnessTuning,
                             ItemId::HoldMode,
                             ItemId::Span,
                             ItemId::Offset,
                             ItemId::HighSetValue,
                             ItemId::LowSetValue,
                             ItemId::Hysteresis,
                             ItemId::TeachingMode,
                             ItemId::Tolerance,
                             ItemId::OutputDelayTimerSelection,
                             ItemId::OutputDelayTimerSetting,
                             ItemId::TriggerMode,
                             ItemId::AlarmDigitalOutput,
                             ItemId::AlarmDelayCount,
                             ItemId::DisplayDigit,
                             ItemId::ZeroSetting};

} // namespace

class SettingsMemoryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void defaultsAreThoseOfTheModel_data();
    void defaultsAreThoseOfTheModel();
    void everyBankHoldsItsOwnValuesOfTheListedItemsOnly();
    void commandsStatusAndTriggerHaveNoPlaceInMemory();
    void switchingTheBankShowsTheOtherValues();
    void copyingABankTakesItsZeroCorrectionAlong();
    void initializingABankLeavesTheOthersAlone();
    void allAreasSparesLanguageAndCommunication();
    void setValueInitializationSparesCommunicationOnly();
    void aBankCarriesItsTunedBrightness();
};

void SettingsMemoryTest::defaultsAreThoseOfTheModel_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("high");
    QTest::addColumn<int>("hysteresis");
    QTest::addColumn<int>("tolerance");
    QTest::addColumn<int>("digit");
    // §4.4.1, §4.4.3, §4.4.5, §4.8.1, in 0.1 µm
    QTest::newRow("30 mm") << int(SensorModel::HlG203) << 50'000 << 100 << 20'000 << 0;
    QTest::newRow("50 mm") << int(SensorModel::HlG205) << 100'000 << 200 << 50'000 << 1;
    QTest::newRow("85 mm") << int(SensorModel::HlG208) << 200'000 << 400 << 100'000 << 1;
    QTest::newRow("120 mm") << int(SensorModel::HlG212) << 300'000 << 600 << 150'000 << 1;
    QTest::newRow("250 mm") << int(SensorModel::HlG225) << 1'500'000 << 3'000 << 1'000'000 << 2;
}

void SettingsMemoryTest::defaultsAreThoseOfTheModel()
{
    QFETCH(int, model);
    QFETCH(int, high);
    QFETCH(int, hysteresis);
    QFETCH(int, tolerance);
    QFETCH(int, digit);
    const SettingsMemory memory{SensorModel(model)};
    QCOMPARE(memory.bank(), 0);
    for (int bank = 0; bank < SettingsMemory::bankCount; ++bank) {
        QCOMPARE(memory.value(ItemId::HighSetValue, bank), high);
        QCOMPARE(memory.value(ItemId::LowSetValue, bank), -high);
        QCOMPARE(memory.value(ItemId::Hysteresis, bank), hysteresis);
        QCOMPARE(memory.value(ItemId::Tolerance, bank), tolerance);
        QCOMPARE(memory.value(ItemId::DisplayDigit, bank), digit);
        QCOMPARE(memory.value(ItemId::AverageTimes, bank), 5);      // 512 times
        QCOMPARE(memory.value(ItemId::SamplingFrequency, bank), 3); // 1 ms
        QCOMPARE(memory.value(ItemId::Span, bank), 10'000);
        QCOMPARE(memory.value(ItemId::AlarmDelayCount, bank), 8);
        QCOMPARE(memory.value(ItemId::TeachingMode, bank), 1);
        QCOMPARE(memory.value(ItemId::OutputDelayTimerSetting, bank), 1);
        QCOMPARE(memory.value(ItemId::ZeroSetting, bank), 0);
    }
    QCOMPARE(memory.value(ItemId::BankSwitching), 1);
    QCOMPARE(memory.value(ItemId::EcoMode), 1);
    QCOMPARE(memory.value(ItemId::LaserStop), 0);
    QCOMPARE(memory.value(ItemId::PortModbus), 502);
    QCOMPARE(memory.value(ItemId::PortTool), 49'152);
    QCOMPARE(memory.value(ItemId::IpAddress1stOctet), 192);
    QCOMPARE(memory.value(ItemId::DefaultGateway4thOctet), 1);
}

void SettingsMemoryTest::everyBankHoldsItsOwnValuesOfTheListedItemsOnly()
{
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (!SettingsMemory::holds(item))
            continue;
        SettingsMemory memory(SensorModel::HlG203);
        const Value before = memory.value(item.id, 1);
        const Value other = before + 1;
        memory.setValue(item.id, other, 0);
        const bool isBanked = std::find(std::begin(banked), std::end(banked), item.id) != std::end(banked);
        QVERIFY2(memory.value(item.id, 1) == (isBanked ? before : other), item.key);
        QCOMPARE(memory.value(item.id, 0), other);
    }
}

void SettingsMemoryTest::commandsStatusAndTriggerHaveNoPlaceInMemory()
{
    for (const ItemId id : {ItemId::SetValueSaving, ItemId::BankCopy, ItemId::MeasuredValue,
                            ItemId::HoldState, ItemId::TriggerInputCommunication, ItemId::ExecutionOfTeaching,
                            ItemId::TeachingExecutionState, ItemId::MacAddress})
        QVERIFY2(!SettingsMemory::holds(hlG2(id)), hlG2(id).key);
    for (const ItemId id : {ItemId::LaserStop, ItemId::KeyLock, ItemId::BankSwitching, ItemId::ZeroSetting,
                            ItemId::PortSlmp, ItemId::DeviceAddress})
        QVERIFY2(SettingsMemory::holds(hlG2(id)), hlG2(id).key);
}

void SettingsMemoryTest::switchingTheBankShowsTheOtherValues()
{
    SettingsMemory memory(SensorModel::HlG203);
    memory.setValue(ItemId::Offset, 77, 2);
    QCOMPARE(memory.value(ItemId::Offset), 0);
    memory.setValue(ItemId::BankSwitching, 3);
    QCOMPARE(memory.bank(), 2);
    QCOMPARE(memory.value(ItemId::Offset), 77);
}

void SettingsMemoryTest::copyingABankTakesItsZeroCorrectionAlong()
{
    SettingsMemory source(SensorModel::HlG203);
    source.setValue(ItemId::Offset, 5, 1);
    source.setZeroCorrection(1, 12'345);
    SettingsMemory memory(SensorModel::HlG203);
    memory.copyBank(source, 1, 3);
    QCOMPARE(memory.value(ItemId::Offset, 3), 5);
    QCOMPARE(memory.zeroCorrection(3), 12'345);
    QCOMPARE(memory.value(ItemId::Offset, 1), 0);
}

void SettingsMemoryTest::initializingABankLeavesTheOthersAlone()
{
    SettingsMemory memory(SensorModel::HlG203);
    for (int bank = 0; bank < SettingsMemory::bankCount; ++bank) {
        memory.setValue(ItemId::Offset, 9, bank);
        memory.setZeroCorrection(bank, 9);
    }
    memory.setValue(ItemId::EcoMode, 0);
    memory.initializeBank(2);
    QCOMPARE(memory.value(ItemId::Offset, 2), 0);
    QCOMPARE(memory.zeroCorrection(2), 0);
    QCOMPARE(memory.value(ItemId::Offset, 1), 9);
    QCOMPARE(memory.zeroCorrection(3), 9);
    QCOMPARE(memory.value(ItemId::EcoMode), 0);
}

void SettingsMemoryTest::allAreasSparesLanguageAndCommunication()
{
    // §4.8.6: all settings except language, NPN/PNP and RS-485/Ethernet communication.
    const SettingsMemory defaults(SensorModel::HlG203);
    SettingsMemory memory = defaults;
    memory.setValue(ItemId::LanguageSetting, 2);
    memory.setValue(ItemId::PortModbus, 1502);
    memory.setValue(ItemId::IpAddress4thOctet, 99);
    memory.setValue(ItemId::DeviceAddress, 7);
    memory.setValue(ItemId::TerminationResistance, 1);
    memory.setInputPolarity(InputPolarity::Pnp);
    const SettingsMemory spared = memory;
    memory.setValue(ItemId::Offset, 9, 3);
    memory.setValue(ItemId::EcoMode, 0);
    memory.setValue(ItemId::KeyLock, 1);
    memory.setValue(ItemId::LaserStop, 1);
    memory.setValue(ItemId::InversionOfMeasuredValue, 1);
    memory.setValue(ItemId::BankSwitching, 4);
    QVERIFY(memory != spared);
    memory.initializeAllAreas();
    QVERIFY(memory == spared);
}

void SettingsMemoryTest::setValueInitializationSparesCommunicationOnly() // §4.8.6
{
    SettingsMemory memory(SensorModel::HlG203);
    memory.setValue(ItemId::PortModbus, 1502);
    memory.setValue(ItemId::CommunicationSpeed, 4);
    const SettingsMemory spared = memory;
    memory.setValue(ItemId::LanguageSetting, 2);
    memory.setInputPolarity(InputPolarity::Pnp);
    memory.setValue(ItemId::Offset, 9, 3);
    memory.setTunedBrightness(1, BrightnessRange{1, 2});
    memory.setValue(ItemId::EcoMode, 0);
    memory.initializeSetValues();
    QVERIFY(memory == spared);
}

void SettingsMemoryTest::aBankCarriesItsTunedBrightness() // §4.2
{
    SettingsMemory memory(SensorModel::HlG203);
    memory.setTunedBrightness(0, BrightnessRange{10, 20});
    QVERIFY(!memory.tunedBrightness(2));
    memory.copyBank(memory, 0, 2);
    QCOMPARE(memory.tunedBrightness(2), (BrightnessRange{10, 20}));
    memory.initializeBank(0);
    QVERIFY(!memory.tunedBrightness(0) && memory.tunedBrightness(2));
}

QTEST_APPLESS_MAIN(SettingsMemoryTest)
#include "tst_settings_memory.moc"

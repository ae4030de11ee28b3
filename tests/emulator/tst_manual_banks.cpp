// §4.2 Bank Switching: which settings belong to a bank, and what switching and copying do.
#include "manual_items.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

/// §4.2 "Types of setting items read from banks", as the manual lists them; brightness tuning and zero
/// setting, which a write cannot simply set, have tests of their own.
const QList<ItemId> banked{ItemId::SamplingFrequency,
                           ItemId::AverageTimes,
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
                           ItemId::DisplayDigit};

/// Settings that are the same in every bank.
const QList<ItemId> common{
    ItemId::LanguageSetting,          ItemId::EcoMode,       ItemId::DisplayInversion,
    ItemId::InversionOfMeasuredValue, ItemId::PortModbus,    ItemId::DeviceAddress,
    ItemId::CommunicationSpeed,       ItemId::ParityStopBit, ItemId::TerminationResistance};

} // namespace

class ManualBanksTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void theSensorStartsInBank1();
    void aBankedSettingIsHeldInTheBankInUse_data() { addRows(banked); }
    void aBankedSettingIsHeldInTheBankInUse();
    void otherSettingsAreTheSameInEveryBank_data() { addRows(common); }
    void otherSettingsAreTheSameInEveryBank();
    void theBanksSettingsAreAppliedToWhatIsMeasured();
    void zeroSettingAndItsCorrectionBelongToTheBank();

    void bankCopyTakesEveryBankedSetting_data() { addRows(banked); }
    void bankCopyTakesEveryBankedSetting();
    void bankCopyTakesTheZeroCorrection();
    void aCopyIsRetainedWhenThePowerIsTurnedOff();
};

void ManualBanksTest::theSensorStartsInBank1() { QCOMPARE(readNow(ItemId::BankSwitching), 1); }

void ManualBanksTest::aBankedSettingIsHeldInTheBankInUse()
{
    QFETCH(int, item);
    const auto id = ItemId(item);
    const Value standard = readNow(id);
    const Value changed = otherThanDefault(hlG2(id), m_sensor->model());
    QVERIFY(changed != standard);
    QVERIFY(write(ItemId::BankSwitching, 3));
    QVERIFY(write(id, changed));
    for (const Value bank : {1, 2, 4}) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        QCOMPARE(readNow(id), standard);
    }
    QVERIFY(write(ItemId::BankSwitching, 3));
    QCOMPARE(readNow(id), changed);
}

void ManualBanksTest::otherSettingsAreTheSameInEveryBank()
{
    QFETCH(int, item);
    const auto id = ItemId(item);
    const Value changed = otherThanDefault(hlG2(id), m_sensor->model());
    QVERIFY(changed != readNow(id));
    QVERIFY(write(id, changed));
    for (const Value bank : {2, 3, 4}) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        QCOMPARE(readNow(id), changed);
    }
}

void ManualBanksTest::theBanksSettingsAreAppliedToWhatIsMeasured()
{
    QVERIFY(write(ItemId::AverageTimes, 0));
    QVERIFY(write(ItemId::BankSwitching, 2));
    QVERIFY(write(ItemId::AverageTimes, 0));
    QVERIFY(write(ItemId::Offset, 1'000));
    QVERIFY(write(ItemId::HighSetValue, 2'000));
    m_sensor->placeWorkpiece(1'500);
    QCOMPARE(value(), 2'500);
    QVERIFY(m_sensor->coil(TimerOffHigh));
    QVERIFY(write(ItemId::BankSwitching, 1));
    m_clock->advanceMs(2);
    QCOMPARE(value(), 1'500);
    QVERIFY(m_sensor->coil(TimerOffGo));
}

void ManualBanksTest::zeroSettingAndItsCorrectionBelongToTheBank()
{
    for (const Value bank : {1, 2}) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        m_sensor->placeWorkpiece(bank * 100);
        QVERIFY(write(ItemId::ZeroSetting, 1));
    }
    for (const Value bank : {1, 2, 3}) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        m_sensor->placeWorkpiece(1'000);
        QCOMPARE(value(), bank == 3 ? 1'000 : 1'000 - bank * 100);
        QCOMPARE(m_sensor->coil(Zero), bank != 3);
    }
}

void ManualBanksTest::bankCopyTakesEveryBankedSetting()
{
    QFETCH(int, item);
    const auto id = ItemId(item);
    const Value standard = readNow(id);
    const Value changed = otherThanDefault(hlG2(id), m_sensor->model());
    QVERIFY(write(ItemId::BankSwitching, 2));
    QVERIFY(write(id, changed));
    QVERIFY(write(ItemId::SetValueSaving, 0)); // what is copied is what was saved
    QVERIFY(write(ItemId::BankCopy, 5));       // bank 2 to bank 4
    QVERIFY(write(ItemId::BankSwitching, 4));
    QCOMPARE(readNow(id), changed);
    for (const Value bank : {1, 3}) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        QCOMPARE(readNow(id), standard);
    }
}

void ManualBanksTest::bankCopyTakesTheZeroCorrection()
{
    m_sensor->placeWorkpiece(700);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QVERIFY(write(ItemId::SetValueSaving, 0));
    QVERIFY(write(ItemId::BankCopy, 1)); // bank 1 to bank 3
    QVERIFY(write(ItemId::BankSwitching, 3));
    QCOMPARE(readNow(ItemId::ZeroSetting), 1);
    m_sensor->placeWorkpiece(900);
    QCOMPARE(value(), 200);
}

void ManualBanksTest::aCopyIsRetainedWhenThePowerIsTurnedOff()
{
    QVERIFY(write(ItemId::Offset, 1'000));
    QVERIFY(write(ItemId::SetValueSaving, 0));
    QVERIFY(write(ItemId::Offset, 2'000)); // never saved
    QVERIFY(write(ItemId::BankCopy, 0));   // bank 1 to bank 2
    m_sensor->powerCycle();
    QCOMPARE(readNow(ItemId::Offset), 1'000);
    QVERIFY(write(ItemId::BankSwitching, 2));
    QCOMPARE(readNow(ItemId::Offset), 1'000);
}

QTEST_GUILESS_MAIN(ManualBanksTest)
#include "tst_manual_banks.moc"

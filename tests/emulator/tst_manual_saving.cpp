// §5.1 and §4.8.5, §4.8.6: what has to be saved, what takes effect when, and what initialization takes back.
#include "manual_items.h"

#include <QSignalSpy>

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

/// §4.8.6: excluded from "All Areas" besides the NPN/PNP setting, which no message reaches.
bool isSparedByAllAreas(ItemId id)
{
    return id == ItemId::LanguageSetting || hlG2(id).effect == Effect::AfterCommunicationReset;
}

} // namespace

class ManualSavingTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void aSettingNotSavedIsGoneWhenThePowerIsTurnedOff_data() { addRows(settingsChangedAlone()); }
    void aSettingNotSavedIsGoneWhenThePowerIsTurnedOff();
    void aSavedSettingIsThereAgain_data() { addRows(settingsChangedAlone()); }
    void aSavedSettingIsThereAgain();
    void allFourBanksAreSaved();
    void aStoppedLaserThatWasSavedStaysStopped();

    void communicationSettingsNeedAResetOrARestart_data();
    void communicationSettingsNeedAResetOrARestart();
    void theAddressNeedsAResetOrARestart();

    void initializingABankTakesItsSettingsBack_data() { addRows(settingsChangedAlone()); }
    void initializingABankTakesItsSettingsBack();
    void initializingAllBanksTakesFourBanksBack_data() { addRows(settingsChangedAlone()); }
    void initializingAllBanksTakesFourBanksBack();
    void allAreasTakesBackAllButLanguageAndCommunication_data() { addRows(settingsChangedAlone()); }
    void allAreasTakesBackAllButLanguageAndCommunication();
    void allAreasLeavesTheAddress();
    void initializationClearsTheTrigger_data();
    void initializationClearsTheTrigger();

private:
    Value change(ItemId id); ///< In the bank in use; answers with the new value.
};

Value ManualSavingTest::change(ItemId id)
{
    const Value changed = otherThanDefault(hlG2(id), m_sensor->model());
    [&] {
        QVERIFY(changed != readNow(id));
        QVERIFY(write(id, changed));
    }();
    return changed;
}

void ManualSavingTest::aSettingNotSavedIsGoneWhenThePowerIsTurnedOff()
{
    QFETCH(int, item);
    const Value standard = readNow(ItemId(item));
    const Value changed = change(ItemId(item));
    QCOMPARE(readNow(ItemId(item)), changed);
    m_sensor->powerCycle();
    QCOMPARE(readNow(ItemId(item)), standard);
}

void ManualSavingTest::aSavedSettingIsThereAgain()
{
    QFETCH(int, item);
    const Value changed = change(ItemId(item));
    QVERIFY(write(ItemId::SetValueSaving, 0));
    m_sensor->powerCycle();
    QCOMPARE(readNow(ItemId(item)), changed);
}

void ManualSavingTest::allFourBanksAreSaved()
{
    for (const Value bank : {1, 2, 3, 4}) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        QVERIFY(write(ItemId::Offset, bank * 100));
    }
    QVERIFY(write(ItemId::SetValueSaving, 0));
    m_sensor->powerCycle();
    for (const Value bank : {1, 2, 3, 4}) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        QCOMPARE(readNow(ItemId::Offset), bank * 100);
    }
}

void ManualSavingTest::aStoppedLaserThatWasSavedStaysStopped()
{
    QVERIFY(write(ItemId::LaserStop, 1));
    QVERIFY(write(ItemId::SetValueSaving, 0));
    m_sensor->powerCycle();
    QCOMPARE(readNow(ItemId::LaserStop), 1);
    QVERIFY(!m_sensor->coil(Laser));
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(value(), -9'999'999);
}

void ManualSavingTest::communicationSettingsNeedAResetOrARestart_data()
{
    addRows({ItemId::PortModbus, ItemId::PortTool, ItemId::CommunicationSpeed, ItemId::ParityStopBit,
             ItemId::DeviceAddress, ItemId::TerminationResistance});
}

void ManualSavingTest::communicationSettingsNeedAResetOrARestart()
{
    QFETCH(int, item);
    const auto id = ItemId(item);
    const Value standard = readNow(id);
    const Value changed = change(id);
    m_clock->advanceMs(60'000);
    QCOMPARE(readNow(id), changed);
    QCOMPARE(m_sensor->activeValue(id), standard);
    const QSignalSpy resets(m_sensor.get(), &VirtualSensor::communicationReset);
    QVERIFY(write(ItemId::ResettingCommunicationSettings, 0));
    QCOMPARE(m_sensor->activeValue(id), changed);
    QCOMPARE(resets.size(), 1);

    QVERIFY(write(id, standard));
    QCOMPARE(m_sensor->activeValue(id), changed);
    QVERIFY(write(ItemId::SetValueSaving, 0));
    QCOMPARE(m_sensor->activeValue(id), changed); // saving alone reflects nothing
    m_sensor->powerCycle();
    QCOMPARE(m_sensor->activeValue(id), standard);
}

void ManualSavingTest::theAddressNeedsAResetOrARestart()
{
    const WriteOutcome outcome = m_sensor->write(anotherNetwork());
    QVERIFY2(!outcome.refusal, qPrintable(outcome.reason));
    QCOMPARE(readNow(ItemId::IpAddress1stOctet), 10);
    QCOMPARE(m_sensor->activeValue(ItemId::IpAddress1stOctet), 192);
    QVERIFY(write(ItemId::ResettingCommunicationSettings, 0));
    for (const ItemWrite& each : anotherNetwork())
        QCOMPARE(m_sensor->activeValue(each.item), each.value);
}

void ManualSavingTest::initializingABankTakesItsSettingsBack()
{
    QFETCH(int, item);
    const auto id = ItemId(item);
    const Value standard = readNow(id);
    QVERIFY(write(ItemId::BankSwitching, 2));
    const Value changed = change(id);
    QVERIFY(write(ItemId::SettingsInitialization, 3));
    QCOMPARE(readNow(id), changed); // another bank
    QVERIFY(write(ItemId::SettingsInitialization, 2));
    QCOMPARE(readNow(id), SettingsMemory::isBanked(id) ? standard : changed);
}

void ManualSavingTest::initializingAllBanksTakesFourBanksBack()
{
    QFETCH(int, item);
    const auto id = ItemId(item);
    const Value standard = readNow(id);
    const Value changed = otherThanDefault(hlG2(id), m_sensor->model());
    for (const Value bank : {1, 2, 3, 4}) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        QVERIFY(write(id, changed));
    }
    QVERIFY(write(ItemId::SettingsInitialization, 5));
    for (const Value bank : {1, 2, 3, 4}) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        QCOMPARE(readNow(id), SettingsMemory::isBanked(id) ? standard : changed);
    }
}

void ManualSavingTest::allAreasTakesBackAllButLanguageAndCommunication()
{
    QFETCH(int, item);
    const auto id = ItemId(item);
    const Value standard = readNow(id);
    const Value changed = change(id);
    QVERIFY(write(ItemId::SettingsInitialization, 6));
    QCOMPARE(readNow(id), isSparedByAllAreas(id) ? changed : standard);
}

void ManualSavingTest::allAreasLeavesTheAddress()
{
    QVERIFY(!m_sensor->write(anotherNetwork()).refusal);
    QVERIFY(write(ItemId::SettingsInitialization, 6));
    for (const ItemWrite& each : anotherNetwork())
        QCOMPARE(readNow(each.item), each.value);
}

void ManualSavingTest::initializationClearsTheTrigger_data()
{
    QTest::addColumn<int>("what");
    for (int what = 1; what <= 6; ++what)
        QTest::addRow("code %d", what) << what;
}

void ManualSavingTest::initializationClearsTheTrigger()
{
    QFETCH(int, what);
    QVERIFY(write(ItemId::TriggerInputCommunication, 1));
    QVERIFY(write(ItemId::SettingsInitialization, what));
    QCOMPARE(readNow(ItemId::TriggerInputCommunication), 0); // §4.6.2 note
}

QTEST_GUILESS_MAIN(ManualSavingTest)
#include "tst_manual_saving.moc"

#include "sensor_fixture.h"

#include <QSignalSpy>
#include <QTest>

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

class VirtualSensorTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void zeroSettingMakesThePlaceZeroOrTheOffset();
    void zeroSettingBelongsToItsBank();
    void zeroSettingFailsWhileUnmeasurable();
    void triggerByCommunicationHolds();
    void triggerIsClearedByWhatTheManualLists();
    void changingTheTriggerModeMakesTheValueIndeterminate();
    void aHoldModeTurnsOneShotIntoHold();
    void resettingTheMeasuredValueStartsTheAverageAfresh();
    void changingTheAverageIsIndeterminateUntilItIsFull();
    void peakHoldOverPollsSeesWhatHappenedBetweenThem();

    void unsavedValuesAreGoneAfterAPowerCycle();
    void savedValuesSurviveAPowerCycle();
    void aStoreThatFailsMakesSavingFail();
    void savingKeepsTheSensorSilent();
    void bankCopyTakesWhatIsSaved_data();
    void bankCopyTakesWhatIsSaved();
    void initializationResetsBanksAndIsSaved();
    void networkSettingsCountAfterACommunicationReset();
    void bankSwitchingShowsTheBanksValues();

    void inItsMenuTheSensorIsNotReady();
    void oneIllegalValueWritesNothing();
    void aFailingItemLeavesWhatWasWrittenBeforeIt();
    void writesAreCounted();
    void changesAtTheKeypadAreSavedAndJudgedByNobody();
    void whatIsWrittenTogetherAtTheKeysIsSavedWithOneWrite();
    void whatTheKeysDidBeforeAFailureIsSaved();
};

void VirtualSensorTest::zeroSettingMakesThePlaceZeroOrTheOffset()
{
    m_sensor->placeWorkpiece(12'345);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QCOMPARE(value(), 0);
    QVERIFY(m_sensor->coil(Zero));
    m_sensor->placeWorkpiece(12'445);
    QCOMPARE(value(), 100);
    QVERIFY(write(ItemId::Offset, 30)); // §4.10: with an offset it becomes the offset
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QCOMPARE(value(), 30);
    QVERIFY(write(ItemId::ZeroSetting, 0));
    QCOMPARE(value(), 12'475);
    QVERIFY(!m_sensor->coil(Zero));
}

void VirtualSensorTest::zeroSettingBelongsToItsBank()
{
    m_sensor->placeWorkpiece(500);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QVERIFY(write(ItemId::BankSwitching, 2));
    m_sensor->placeWorkpiece(500);
    QCOMPARE(value(), 500);
    QCOMPARE(readNow(ItemId::ZeroSetting), 0);
    QVERIFY(write(ItemId::BankSwitching, 1));
    m_sensor->placeWorkpiece(500);
    QCOMPARE(value(), 0);
    QCOMPARE(readNow(ItemId::ZeroSetting), 1);
}

void VirtualSensorTest::zeroSettingFailsWhileUnmeasurable()
{
    m_sensor->setLight(Light::Insufficient);
    m_clock->advanceMs(1); // the value is still shown, but zero cannot be set (§4.10)
    const WriteOutcome outcome = m_sensor->write({{ItemId::ZeroSetting, 1}});
    QCOMPARE(outcome.refusal, Refusal::Failed);
    QVERIFY(!m_sensor->coil(Zero));
    QVERIFY(write(ItemId::ZeroSetting, 0));
}

void VirtualSensorTest::triggerByCommunicationHolds()
{
    QVERIFY(write(ItemId::AverageTimes, 0));
    m_sensor->placeWorkpiece(10);
    QVERIFY(write(ItemId::TriggerInputCommunication, 1));
    m_sensor->placeWorkpiece(20);
    QCOMPARE(value(), 10);
    QVERIFY(m_sensor->coil(Hold));
    QCOMPARE(m_sensor->read(ItemId::HoldState), 1);
    QCOMPARE(m_sensor->read(ItemId::TriggerInputCommunication), 1);
    QVERIFY(write(ItemId::TriggerInputCommunication, 0));
    QCOMPARE(value(), 20);
    QVERIFY(!m_sensor->coil(Hold));
    m_sensor->setExternalTrigger(true);
    m_clock->advanceMs(2);
    QCOMPARE(readNow(ItemId::TriggerInputExternal), 1);
    QVERIFY(m_sensor->coil(Hold));
}

void VirtualSensorTest::triggerIsClearedByWhatTheManualLists()
{
    const QList<ItemWrite> clearing{{ItemId::BankSwitching, 2},
                                    {ItemId::BankCopy, 11},
                                    {ItemId::SettingsInitialization, 3},
                                    {ItemId::TriggerMode, 1},
                                    {ItemId::HoldMode, 1}}; // the last turns One Shot into Hold
    for (const ItemWrite& each : clearing) {
        QVERIFY(write(ItemId::TriggerInputCommunication, 1));
        QVERIFY(write(each.item, each.value));
        QVERIFY2(m_sensor->read(ItemId::TriggerInputCommunication) == 0, hlG2(each.item).key);
    }
    QVERIFY(write(ItemId::TriggerInputCommunication, 1));
    QVERIFY(write(ItemId::EcoMode, 0));
    QCOMPARE(m_sensor->read(ItemId::TriggerInputCommunication), 1);
}

void VirtualSensorTest::changingTheTriggerModeMakesTheValueIndeterminate()
{
    QVERIFY(write(ItemId::AverageTimes, 0));
    m_sensor->placeWorkpiece(10);
    QVERIFY(write(ItemId::TriggerMode, 1));
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(value(), -9'999'999); // One Shot: until the first trigger
    QVERIFY(m_sensor->coil(Indeterminate));
    QVERIFY(write(ItemId::TriggerInputCommunication, 1));
    QVERIFY(write(ItemId::TriggerInputCommunication, 0));
    m_sensor->placeWorkpiece(20);
    QCOMPARE(value(), 10);
}

void VirtualSensorTest::aHoldModeTurnsOneShotIntoHold()
{
    QVERIFY(write(ItemId::TriggerMode, 1));
    QVERIFY(write(ItemId::HoldMode, 2));
    QCOMPARE(m_sensor->read(ItemId::TriggerMode), 0);
    QVERIFY(!write(ItemId::TriggerMode, 1));
    QVERIFY(write(ItemId::HoldMode, 0));
    QCOMPARE(m_sensor->read(ItemId::TriggerMode), 0); // it does not come back by itself
}

void VirtualSensorTest::resettingTheMeasuredValueStartsTheAverageAfresh()
{
    QVERIFY(write(ItemId::HoldMode, 1));
    m_sensor->placeWorkpiece(900);
    m_sensor->placeWorkpiece(100);
    QCOMPARE(value(), 900);
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    for (const int coil : {High, Go, Low})
        QVERIFY(!m_sensor->coil(coil)); // §4.11
    QCOMPARE(value(), -9'999'999);
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(value(), 100);
}

void VirtualSensorTest::changingTheAverageIsIndeterminateUntilItIsFull()
{
    m_sensor->placeWorkpiece(100);
    QVERIFY(write(ItemId::AverageTimes, 2)); // 16 samples of 1 ms
    QVERIFY(m_sensor->coil(Indeterminate));
    m_clock->advanceMs(14);
    QCOMPARE(value(), -9'999'999);
    m_clock->advanceMs(2);
    QCOMPARE(value(), 100);
    QVERIFY(write(ItemId::AverageTimes, 2)); // no change, nothing lost
    QCOMPARE(value(), 100);
}

void VirtualSensorTest::peakHoldOverPollsSeesWhatHappenedBetweenThem()
{
    QVERIFY(write(ItemId::AverageTimes, 0));
    QVERIFY(write(ItemId::SamplingFrequency, 4)); // 2 ms
    QVERIFY(write(ItemId::HoldMode, 3));
    m_clock->advanceMs(8000); // nearly a period of the movement, in one step
    QVERIFY(value() > 40'000);
}

void VirtualSensorTest::unsavedValuesAreGoneAfterAPowerCycle()
{
    QVERIFY(write(ItemId::Offset, 10));
    QVERIFY(write(ItemId::EcoMode, 0));
    QVERIFY(write(ItemId::BankSwitching, 3));
    m_sensor->powerCycle();
    QCOMPARE(readNow(ItemId::Offset), 0);
    QCOMPARE(readNow(ItemId::EcoMode), 1);
    QCOMPARE(readNow(ItemId::BankSwitching), 1);
    QCOMPARE(m_sensor->memoryWriteCount(), 0);
}

void VirtualSensorTest::savedValuesSurviveAPowerCycle()
{
    SettingsMemory stored(SensorModel::HlG203);
    m_sensor->setStore(
        [&stored](const SettingsMemory& memory, const LifeCounters&) -> tl::expected<void, QString> {
            stored = memory;
            return {};
        });
    m_sensor->placeWorkpiece(400);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QVERIFY(write(ItemId::BankSwitching, 2));
    QVERIFY(write(ItemId::Offset, 10));
    QVERIFY(write(ItemId::SetValueSaving, 0));
    QCOMPARE(m_sensor->memoryWriteCount(), 1);
    QVERIFY(write(ItemId::Offset, 20));
    QVERIFY(stored == m_sensor->savedMemory());
    m_sensor->powerCycle();
    QCOMPARE(readNow(ItemId::BankSwitching), 2);
    QCOMPARE(readNow(ItemId::Offset), 10);
    QCOMPARE(m_sensor->memory().zeroCorrection(0), 40'000);
    QCOMPARE(value(), -9'999'999); // the average starts empty
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(value(), 410);
    QVERIFY(m_sensor->memory() == stored);
}

void VirtualSensorTest::aStoreThatFailsMakesSavingFail()
{
    m_sensor->setStore([](const SettingsMemory&, const LifeCounters&) -> tl::expected<void, QString> {
        return tl::unexpected(QStringLiteral("disk full"));
    });
    const QSignalSpy failures(m_sensor.get(), &VirtualSensor::storeFailed);
    QVERIFY(write(ItemId::Offset, 10));
    QCOMPARE(m_sensor->write({{ItemId::SetValueSaving, 0}}).refusal, Refusal::Failed);
    QCOMPARE(failures.size(), 1);
    QCOMPARE(m_sensor->savedMemory().value(ItemId::Offset), 0);
    QCOMPARE(m_sensor->write({{ItemId::BankCopy, 0}}).refusal, Refusal::Failed);
    QCOMPARE(m_sensor->write({{ItemId::SettingsInitialization, 5}}).refusal, Refusal::Failed);
    QCOMPARE(readNow(ItemId::Offset), 10); // nothing was initialized
    QCOMPARE(m_sensor->memoryWriteCount(), 0);
}

void VirtualSensorTest::savingKeepsTheSensorSilent()
{
    m_sensor->setSavingDuration(300);
    QCOMPARE(m_sensor->silentForMs(), 0);
    QVERIFY(write(ItemId::SetValueSaving, 0));
    QCOMPARE(m_sensor->silentForMs(), 300);
    m_clock->advanceMs(299);
    QCOMPARE(m_sensor->silentForMs(), 1);
    m_clock->advanceMs(1);
    QCOMPARE(m_sensor->silentForMs(), 0);
}

void VirtualSensorTest::bankCopyTakesWhatIsSaved_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    // §4.2
    constexpr int combinations[12][2] = {{1, 2}, {1, 3}, {1, 4}, {2, 1}, {2, 3}, {2, 4},
                                         {3, 1}, {3, 2}, {3, 4}, {4, 1}, {4, 2}, {4, 3}};
    for (int code = 0; code < 12; ++code)
        QTest::addRow("%d to %d", combinations[code][0], combinations[code][1])
            << code << combinations[code][0] << combinations[code][1];
}

void VirtualSensorTest::bankCopyTakesWhatIsSaved()
{
    QFETCH(int, code);
    QFETCH(int, from);
    QFETCH(int, to);
    for (int bank = 1; bank <= 4; ++bank) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        QVERIFY(write(ItemId::Offset, bank * 100));
    }
    QVERIFY(write(ItemId::SetValueSaving, 0));
    for (int bank = 1; bank <= 4; ++bank) {
        QVERIFY(write(ItemId::BankSwitching, bank));
        QVERIFY(write(ItemId::Offset, bank * 100 + 1)); // not saved
    }
    QVERIFY(write(ItemId::BankCopy, code));
    for (int bank = 1; bank <= 4; ++bank) {
        const Value inUse = bank == to ? from * 100 : bank * 100 + 1;
        const Value saved = bank == to ? from * 100 : bank * 100;
        QCOMPARE(m_sensor->memory().value(ItemId::Offset, bank - 1), inUse);
        QCOMPARE(m_sensor->savedMemory().value(ItemId::Offset, bank - 1), saved);
    }
    QCOMPARE(m_sensor->memoryWriteCount(), 2);
}

void VirtualSensorTest::initializationResetsBanksAndIsSaved()
{
    const auto spoil = [this] {
        for (int bank = 1; bank <= 4; ++bank) {
            QVERIFY(write(ItemId::BankSwitching, bank));
            QVERIFY(write(ItemId::Offset, 50));
        }
        QVERIFY(write(ItemId::KeyLock, 1));
        QVERIFY(write(ItemId::SetValueSaving, 0));
    };
    for (Value what = 1; what <= 6; ++what) {
        spoil();
        QVERIFY(write(ItemId::SettingsInitialization, what));
        for (const SettingsMemory& memory : {m_sensor->memory(), m_sensor->savedMemory()}) {
            for (int bank = 1; bank <= 4; ++bank)
                QCOMPARE(memory.value(ItemId::Offset, bank - 1), what >= 5 || what == bank ? 0 : 50);
            QCOMPARE(memory.value(ItemId::KeyLock), what == 6 ? 0 : 1);
            QCOMPARE(memory.value(ItemId::BankSwitching), what == 6 ? 1 : 4);
        }
    }
}

void VirtualSensorTest::networkSettingsCountAfterACommunicationReset()
{
    const QSignalSpy resets(m_sensor.get(), &VirtualSensor::communicationReset);
    QVERIFY(write(ItemId::PortModbus, 1502));
    QCOMPARE(readNow(ItemId::PortModbus), 1502);
    QCOMPARE(m_sensor->activeValue(ItemId::PortModbus), 502);
    QVERIFY(write(ItemId::ResettingCommunicationSettings, 0));
    QCOMPARE(m_sensor->activeValue(ItemId::PortModbus), 1502);
    QCOMPARE(resets.size(), 1);
    m_sensor->powerCycle(); // it was not saved
    QCOMPARE(m_sensor->activeValue(ItemId::PortModbus), 502);
}

void VirtualSensorTest::bankSwitchingShowsTheBanksValues()
{
    QVERIFY(write(ItemId::HighSetValue, 40'000));
    QVERIFY(write(ItemId::BankSwitching, 2));
    QCOMPARE(readNow(ItemId::HighSetValue), 50'000);
    QVERIFY(write(ItemId::HighSetValue, 30'000));
    QVERIFY(write(ItemId::BankSwitching, 1));
    QCOMPARE(readNow(ItemId::HighSetValue), 40'000);
}

void VirtualSensorTest::inItsMenuTheSensorIsNotReady()
{
    m_sensor->setInMenu(true);
    const WriteOutcome outcome = m_sensor->write({{ItemId::EcoMode, 0}});
    QCOMPARE(outcome.refusal, Refusal::NotReady);
    QCOMPARE(m_sensor->writeCount(ItemId::EcoMode), 0);
    m_sensor->setInMenu(false);
    QCOMPARE(readNow(ItemId::EcoMode), 1);
    QVERIFY(write(ItemId::EcoMode, 0));
}

void VirtualSensorTest::oneIllegalValueWritesNothing()
{
    const WriteOutcome outcome = m_sensor->write({{ItemId::EcoMode, 0}, {ItemId::DisplayDigit, 200}});
    QCOMPARE(outcome.refusal, Refusal::Data);
    QCOMPARE(outcome.written, 0);
    QVERIFY2(outcome.reason.contains(QLatin1String(hlG2(ItemId::DisplayDigit).key)),
             qPrintable(outcome.reason));
    QCOMPARE(readNow(ItemId::EcoMode), 1);
    QCOMPARE(m_sensor->totalWriteCount(), 0);
}

void VirtualSensorTest::aFailingItemLeavesWhatWasWrittenBeforeIt()
{
    m_sensor->setWriteFailure(ItemId::AlarmDelayCount, true);
    const QSignalSpy writtenItems(m_sensor.get(), &VirtualSensor::written);
    const WriteOutcome outcome =
        m_sensor->write({{ItemId::EcoMode, 0}, {ItemId::AlarmDelayCount, 3}, {ItemId::DisplayDigit, 2}});
    QCOMPARE(outcome.refusal, Refusal::Failed);
    QCOMPARE(outcome.written, 1);
    QCOMPARE(writtenItems.size(), 1);
    QCOMPARE(readNow(ItemId::EcoMode), 0);
    QCOMPARE(readNow(ItemId::AlarmDelayCount), 8);
    QCOMPARE(readNow(ItemId::DisplayDigit), 0);
    m_sensor->setWriteFailure(ItemId::AlarmDelayCount, false);
    QVERIFY(write(ItemId::AlarmDelayCount, 3));
}

void VirtualSensorTest::writesAreCounted()
{
    QVERIFY(write(ItemId::EcoMode, 0));
    QVERIFY(write(ItemId::EcoMode, 0));
    QVERIFY(write(ItemId::SetValueSaving, 0));
    QCOMPARE(m_sensor->writeCount(ItemId::EcoMode), 2);
    QCOMPARE(m_sensor->writeCount(ItemId::SetValueSaving), 1);
    QCOMPARE(m_sensor->writeCount(ItemId::Offset), 0);
    QCOMPARE(m_sensor->totalWriteCount(), 3);
}

void VirtualSensorTest::changesAtTheKeypadAreSavedAndJudgedByNobody()
{
    QVERIFY(write(ItemId::Offset, 7)); // not saved
    m_sensor->changeByKeypad(ItemId::HighSetValue, -90'000);
    QCOMPARE(readNow(ItemId::HighSetValue), -90'000); // below LOW
    QCOMPARE(m_sensor->writeCount(ItemId::HighSetValue), 0);
    m_sensor->changeByKeypad(ItemId::BankSwitching, 2);
    m_sensor->changeByKeypad(ItemId::Offset, 9);
    m_sensor->powerCycle();
    QCOMPARE(readNow(ItemId::BankSwitching), 2);
    QCOMPARE(readNow(ItemId::Offset), 9);
    QCOMPARE(m_sensor->memory().value(ItemId::HighSetValue, 0), -90'000);
    QCOMPARE(m_sensor->memory().value(ItemId::Offset, 0), 0);
}

void VirtualSensorTest::whatIsWrittenTogetherAtTheKeysIsSavedWithOneWrite()
{
    QList<std::pair<Value, Value>> stored; // an address is there whole or not at all
    m_sensor->setStore(
        [&stored](const SettingsMemory& memory, const LifeCounters&) -> tl::expected<void, QString> {
            stored.append(
                {memory.value(ItemId::IpAddress3rdOctet), memory.value(ItemId::DefaultGateway3rdOctet)});
            return {};
        });
    QVERIFY(write(ItemId::Offset, 7)); // not saved, and not by the way either
    const WriteOutcome outcome =
        m_sensor->writeByKeys({{ItemId::IpAddress3rdOctet, 9}, {ItemId::DefaultGateway3rdOctet, 9}});
    QVERIFY(!outcome.refusal);
    QCOMPARE(outcome.written, 2);
    QCOMPARE(stored, (QList<std::pair<Value, Value>>{{9, 9}}));
    QCOMPARE(m_sensor->memoryWriteCount(), 1);
    QCOMPARE(m_sensor->savedMemory().value(ItemId::Offset), 0);
}

void VirtualSensorTest::whatTheKeysDidBeforeAFailureIsSaved()
{
    m_sensor->setWriteFailure(ItemId::AlarmDelayCount, true);
    const WriteOutcome outcome = m_sensor->writeByKeys({{ItemId::EcoMode, 0}, {ItemId::AlarmDelayCount, 3}});
    QCOMPARE(outcome.refusal, Refusal::Failed);
    QCOMPARE(m_sensor->savedMemory().value(ItemId::EcoMode), 0);
    QCOMPARE(m_sensor->savedMemory().value(ItemId::AlarmDelayCount), 8);
}

QTEST_GUILESS_MAIN(VirtualSensorTest)
#include "tst_virtual_sensor.moc"

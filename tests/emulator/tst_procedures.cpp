#include "sensor_fixture.h"

#include <QTest>

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;

/// Teaching (§4.9) and brightness tuning (§4.3.3) of a whole sensor, by communication and by keys.
class ProceduresTest : public SensorFixture {
    Q_OBJECT

    int teachingState() { return readNow(ItemId::TeachingExecutionState); }
    int tuningState() { return readNow(ItemId::BrightnessTuningExecutionState); }

    /// A still scenery of this brightness.
    void look(double reflectance, Value distance = 0)
    {
        struct Still final : Scenery {
            Sight sight;
            Sight at(qint64) const override { return sight; }
        };
        auto still = std::make_shared<Still>();
        still->sight = {true, distance * nanometresPerWireUnit, reflectance, 0};
        m_sensor->setScenery(still);
        m_clock->advanceMs(2 * averageFullMs);
    }

private Q_SLOTS:
    void init() { setUp(); }

    void onePointByCommunication();
    void twoPointsByCommunication();
    void threePointsByCommunication();
    void aFailedTeachingLeavesHighAndLow();
    void teachingCannotStartWithAHoldMode();
    void pointsOutOfOrderAreRefused();
    void teachingInHoldStateFailsAndIsIndeterminateAfterwards();
    void teachingFailsInAlarmIndeterminateAndOver();
    void executionStatesGoBackAsChosen();
    void teachingUsesTheFinalMeasuredValue();
    void aTaughtWindowIsSavedByKeysOnly();
    void switchingBanksEndsAProcedure();
    void aPowerCycleEndsAProcedure();
    void keysHaveNoScreensWhileCommunicationTeaches();
    void notReadyInItsMenu();

    void tuningByCommunication();
    void tuningFailsWithoutLightAndKeepsTheOldMethod();
    void tuningFailsWhenTheLightIsNeverSteady();
    void tuningCannotStartWithAHoldMode();
    void tuningInHoldStateFailsAndIsIndeterminateAfterwards();
    void tuningPointsOutOfOrderAreRefused();
    void writingOffEndsTuning();
    void tuningMakesDarkAndBrightMeasurableAtOnce();
    void aTunedRangeBelongsToItsBankAndIsCopiedWithIt();
    void oneProcedureAtATime();
    void tuningByKeysIsSaved();
};

void ProceduresTest::onePointByCommunication() // §4.9.1
{
    m_sensor->placeWorkpiece(1'000);
    QCOMPARE(teachingState(), 0);
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    QCOMPARE(teachingState(), 1);
    QVERIFY(m_sensor->procedureByCommunication());
    QVERIFY(write(ItemId::Teaching1stPoint, 0));
    QCOMPARE(teachingState(), 2);
    QVERIFY(!m_sensor->procedureByCommunication());
    QCOMPARE(readNow(ItemId::HighSetValue), 21'000);
    QCOMPARE(readNow(ItemId::LowSetValue), -19'000);
    QVERIFY(m_sensor->coil(Go));
}

void ProceduresTest::twoPointsByCommunication() // §4.9.2
{
    QVERIFY(write(ItemId::TeachingMode, 2));
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    m_sensor->placeWorkpiece(-3'000);
    QVERIFY(write(ItemId::Teaching1stPoint, 0));
    QCOMPARE(teachingState(), 1);
    QCOMPARE(readNow(ItemId::HighSetValue), 50'000); // not before the last point
    m_sensor->placeWorkpiece(4'000);
    QVERIFY(write(ItemId::Teaching2ndPoint, 0));
    QCOMPARE(teachingState(), 2);
    QCOMPARE(readNow(ItemId::HighSetValue), 4'000);
    QCOMPARE(readNow(ItemId::LowSetValue), -3'000);
}

void ProceduresTest::threePointsByCommunication() // §4.9.3
{
    QVERIFY(write(ItemId::TeachingMode, 3));
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    const QList<std::pair<Value, ItemId>> points{{2'000, ItemId::Teaching1stPoint},
                                                 {8'000, ItemId::Teaching2ndPoint},
                                                 {-4'000, ItemId::Teaching3rdPoint}};
    for (const auto& [distance, point] : points) {
        QCOMPARE(teachingState(), 1);
        m_sensor->placeWorkpiece(distance);
        QVERIFY(write(point, 0));
    }
    QCOMPARE(teachingState(), 2);
    QCOMPARE(readNow(ItemId::HighSetValue), 5'000);
    QCOMPARE(readNow(ItemId::LowSetValue), -1'000);
}

void ProceduresTest::aFailedTeachingLeavesHighAndLow()
{
    QVERIFY(write(ItemId::TeachingMode, 2));
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    m_sensor->placeWorkpiece(500);
    QVERIFY(write(ItemId::Teaching1stPoint, 0));
    QVERIFY(write(ItemId::Teaching2ndPoint, 0)); // the same value
    QCOMPARE(teachingState(), 3);
    QCOMPARE(readNow(ItemId::HighSetValue), 50'000);
    QCOMPARE(readNow(ItemId::LowSetValue), -50'000);
}

void ProceduresTest::teachingCannotStartWithAHoldMode()
{
    QVERIFY(write(ItemId::HoldMode, 1));
    QCOMPARE(m_sensor->write({{ItemId::ExecutionOfTeaching, 1}}).refusal, Refusal::Failed);
    QCOMPARE(teachingState(), 0);
}

void ProceduresTest::pointsOutOfOrderAreRefused()
{
    QCOMPARE(m_sensor->write({{ItemId::Teaching1stPoint, 0}}).refusal, Refusal::Failed);
    QVERIFY(write(ItemId::TeachingMode, 2));
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    for (const ItemId wrong : {ItemId::Teaching2ndPoint, ItemId::Teaching3rdPoint})
        QCOMPARE(m_sensor->write({{wrong, 0}}).refusal, Refusal::Failed);
    QCOMPARE(teachingState(), 1); // still waiting for the first
    QVERIFY(write(ItemId::Teaching1stPoint, 0));
    QCOMPARE(m_sensor->write({{ItemId::Teaching1stPoint, 0}}).refusal, Refusal::Failed);
    QCOMPARE(m_sensor->write({{ItemId::Teaching2ndPoint, 1}}).refusal, Refusal::Data); // reserved value
    QCOMPARE(teachingState(), 1);
}

void ProceduresTest::teachingInHoldStateFailsAndIsIndeterminateAfterwards() // §4.9 note
{
    QVERIFY(write(ItemId::TriggerInputCommunication, 1));
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    QVERIFY(write(ItemId::Teaching1stPoint, 0));
    QCOMPARE(teachingState(), 3);
    QCOMPARE(value(), -9'999'999);
    QVERIFY(m_sensor->coil(Indeterminate));
}

void ProceduresTest::teachingFailsInAlarmIndeterminateAndOver()
{
    const auto teach = [this] {
        write(ItemId::ExecutionOfTeaching, 1);
        write(ItemId::Teaching1stPoint, 0);
        return teachingState();
    };
    m_sensor->setFault(SensorFault::NoLight, true);
    m_clock->advanceMs(20);
    QCOMPARE(teach(), 3); // alarm, though the last value is still shown
    m_sensor->setFault(SensorFault::NoLight, false);
    m_clock->advanceMs(20);
    QCOMPARE(teach(), 2);
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    QCOMPARE(teach(), 3); // indeterminate
    QVERIFY(write(ItemId::Offset, 95'000));
    m_sensor->placeWorkpiece(1);
    QCOMPARE(value(), 9'600'000);
    QCOMPARE(teach(), 3); // +OVER
}

void ProceduresTest::executionStatesGoBackAsChosen() // docs/conformance.md
{
    m_sensor->placeWorkpiece(0);
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    QVERIFY(write(ItemId::Teaching1stPoint, 0));
    QCOMPARE(teachingState(), 2);
    QCOMPARE(teachingState(), 2); // reading changes nothing
    QVERIFY(write(ItemId::TeachingMode, 1));
    QCOMPARE(teachingState(), 0);
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    QVERIFY(write(ItemId::ExecutionOfTeaching, 0));
    QCOMPARE(teachingState(), 0);
    QVERIFY(write(ItemId::ExecutionOfTeaching, 0)); // nothing runs, nothing to complain of
}

void ProceduresTest::teachingUsesTheFinalMeasuredValue()
{
    QVERIFY(write(ItemId::Span, 20'000));
    QVERIFY(write(ItemId::Offset, 500));
    QVERIFY(write(ItemId::InversionOfMeasuredValue, 1));
    m_sensor->placeWorkpiece(1'000);
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    QVERIFY(write(ItemId::Teaching1stPoint, 0));
    QCOMPARE(readNow(ItemId::HighSetValue), 18'500); // −1 × 2 + 0.05 mm + tolerance
}

void ProceduresTest::aTaughtWindowIsSavedByKeysOnly()
{
    m_sensor->placeWorkpiece(1'000);
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    QVERIFY(write(ItemId::Teaching1stPoint, 0));
    QCOMPARE(m_sensor->savedMemory().value(ItemId::HighSetValue), 50'000);
    QVERIFY(!m_sensor->startTeaching(Operator::Keys).refusal);
    QVERIFY(!m_sensor->procedureByCommunication());
    QVERIFY(!m_sensor->takeTeachingPoint(1).refusal);
    QCOMPARE(m_sensor->savedMemory().value(ItemId::HighSetValue), 21'000);
    QCOMPARE(m_sensor->savedMemory().value(ItemId::LowSetValue), -19'000);
}

void ProceduresTest::switchingBanksEndsAProcedure()
{
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    QVERIFY(write(ItemId::BankSwitching, 2));
    QCOMPARE(teachingState(), 0);
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QVERIFY(write(ItemId::BankSwitching, 1));
    QCOMPARE(tuningState(), 0);
    QCOMPARE(m_sensor->memory().value(ItemId::BrightnessTuning, 1), 0);
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QVERIFY(write(ItemId::SettingsInitialization, 1));
    QCOMPARE(tuningState(), 0);
    QCOMPARE(readNow(ItemId::BrightnessTuning), 0);
}

void ProceduresTest::aPowerCycleEndsAProcedure()
{
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    m_sensor->powerCycle();
    QCOMPARE(teachingState(), 0);
    m_clock->advanceMs(averageFullMs);
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    m_sensor->powerCycle();
    QCOMPARE(tuningState(), 0);
    QCOMPARE(readNow(ItemId::BrightnessTuning), 0);
}

void ProceduresTest::keysHaveNoScreensWhileCommunicationTeaches()
{
    QVERIFY(!m_sensor->procedureByCommunication());
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QVERIFY(m_sensor->procedureByCommunication());
    QVERIFY(write(ItemId::BrightnessTuning, 0));
    QVERIFY(!m_sensor->procedureByCommunication());
}

void ProceduresTest::notReadyInItsMenu()
{
    m_sensor->setFault(SensorFault::InMenu, true);
    QCOMPARE(m_sensor->write({{ItemId::ExecutionOfTeaching, 1}}).refusal, Refusal::NotReady);
    QCOMPARE(teachingState(), 0);
}

void ProceduresTest::tuningByCommunication() // §4.3.3
{
    look(5);
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QCOMPARE(tuningState(), 1);
    QCOMPARE(readNow(ItemId::BrightnessTuning), 1);
    QVERIFY(write(ItemId::BrightnessTuning1stPoint, 0));
    QCOMPARE(tuningState(), 1); // adjusting
    m_clock->advanceMs(100);
    QCOMPARE(tuningState(), 2);
    look(0.05);
    QCOMPARE(tuningState(), 2);
    QVERIFY(write(ItemId::BrightnessTuning2ndPoint, 0));
    m_clock->advanceMs(100);
    QCOMPARE(tuningState(), 3);
    QCOMPARE(readNow(ItemId::BrightnessTuning), 1);
    const auto range = m_sensor->memory().tunedBrightness(0);
    QVERIFY(range && range->highest > 20 * range->lowest);
    QVERIFY(!m_sensor->savedMemory().tunedBrightness(0));
}

void ProceduresTest::tuningFailsWithoutLightAndKeepsTheOldMethod()
{
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    m_sensor->setFault(SensorFault::NoLight, true);
    m_clock->advanceMs(20);
    QVERIFY(write(ItemId::BrightnessTuning1stPoint, 0)); // alarm state
    QCOMPARE(tuningState(), 4);
    QCOMPARE(readNow(ItemId::BrightnessTuning), 0);
    m_sensor->setFault(SensorFault::NoLight, false);
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    QVERIFY(write(ItemId::BrightnessTuning1stPoint, 0)); // indeterminate state
    QCOMPARE(tuningState(), 4);
}

void ProceduresTest::tuningFailsWhenTheLightIsNeverSteady()
{
    struct Flicker final : Scenery {
        Sight at(qint64 timeNs) const override
        {
            return {true, 0, timeNs / 5'000'000 % 2 != 0 ? 1.0 : 3.0, 0}; // every 5 ms
        }
    };
    m_sensor->setScenery(std::make_shared<Flicker>());
    m_clock->advanceMs(2 * averageFullMs);
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QVERIFY(write(ItemId::BrightnessTuning1stPoint, 0));
    m_clock->advanceMs(900);
    QCOMPARE(tuningState(), 1);
    m_clock->advanceMs(200);
    QCOMPARE(tuningState(), 4);
    QCOMPARE(readNow(ItemId::BrightnessTuning), 0);
}

void ProceduresTest::tuningCannotStartWithAHoldMode()
{
    QVERIFY(write(ItemId::HoldMode, 3));
    QCOMPARE(m_sensor->write({{ItemId::BrightnessTuning, 1}}).refusal, Refusal::Failed);
    QCOMPARE(tuningState(), 0);
    QCOMPARE(readNow(ItemId::BrightnessTuning), 0);
}

void ProceduresTest::tuningInHoldStateFailsAndIsIndeterminateAfterwards()
{
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QVERIFY(write(ItemId::TriggerInputCommunication, 1));
    QVERIFY(write(ItemId::BrightnessTuning1stPoint, 0));
    QCOMPARE(tuningState(), 4);
    QCOMPARE(value(), -9'999'999);
}

void ProceduresTest::tuningPointsOutOfOrderAreRefused()
{
    QCOMPARE(m_sensor->write({{ItemId::BrightnessTuning1stPoint, 0}}).refusal, Refusal::Failed);
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QCOMPARE(m_sensor->write({{ItemId::BrightnessTuning2ndPoint, 0}}).refusal, Refusal::Failed);
    QVERIFY(write(ItemId::BrightnessTuning1stPoint, 0));
    QCOMPARE(m_sensor->write({{ItemId::BrightnessTuning2ndPoint, 0}}).refusal, Refusal::Failed); // adjusting
    QCOMPARE(tuningState(), 1);
}

void ProceduresTest::writingOffEndsTuning()
{
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QVERIFY(write(ItemId::BrightnessTuning1stPoint, 0));
    QVERIFY(write(ItemId::BrightnessTuning, 0));
    QCOMPARE(tuningState(), 0);
    QCOMPARE(readNow(ItemId::BrightnessTuning), 0);
    m_clock->advanceMs(2'000);
    QCOMPARE(tuningState(), 0);
}

void ProceduresTest::tuningMakesDarkAndBrightMeasurableAtOnce()
{
    const auto alarms = [this] { // after bright comes dark
        look(5);
        struct Dark final : Scenery {
            Sight at(qint64) const override { return {true, 0, 0.05, 0}; }
        };
        m_sensor->setScenery(std::make_shared<Dark>());
        m_clock->advanceMs(5);
        m_sensor->catchUp();
        return m_sensor->coil(InsufficientLight);
    };
    QVERIFY(write(ItemId::AlarmDelayCount, 1));
    QVERIFY(alarms());
    look(5);
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QVERIFY(write(ItemId::BrightnessTuning1stPoint, 0));
    m_clock->advanceMs(100);
    look(0.05);
    QVERIFY(write(ItemId::BrightnessTuning2ndPoint, 0));
    m_clock->advanceMs(100);
    QCOMPARE(tuningState(), 3);
    QVERIFY(!alarms());
}

void ProceduresTest::aTunedRangeBelongsToItsBankAndIsCopiedWithIt() // §4.2
{
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    for (const ItemId point : {ItemId::BrightnessTuning1stPoint, ItemId::BrightnessTuning2ndPoint}) {
        QVERIFY(write(point, 0));
        m_clock->advanceMs(100);
    }
    QCOMPARE(tuningState(), 3);
    QVERIFY(write(ItemId::SetValueSaving, 0));
    QVERIFY(write(ItemId::BankCopy, 2)); // bank 1 to bank 4
    QVERIFY(m_sensor->memory().tunedBrightness(3));
    QCOMPARE(m_sensor->memory().tunedBrightness(3), m_sensor->memory().tunedBrightness(0));
    QVERIFY(!m_sensor->memory().tunedBrightness(1));
    QVERIFY(write(ItemId::SettingsInitialization, 4));
    QVERIFY(!m_sensor->memory().tunedBrightness(3));
}

void ProceduresTest::oneProcedureAtATime()
{
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    QCOMPARE(m_sensor->write({{ItemId::BrightnessTuning, 1}}).refusal, Refusal::Failed);
    QVERIFY(write(ItemId::ExecutionOfTeaching, 0));
    QVERIFY(write(ItemId::BrightnessTuning, 1));
    QCOMPARE(m_sensor->write({{ItemId::ExecutionOfTeaching, 1}}).refusal, Refusal::Failed);
}

void ProceduresTest::tuningByKeysIsSaved()
{
    QVERIFY(!m_sensor->startTuning(Operator::Keys).refusal);
    QVERIFY(!m_sensor->procedureByCommunication());
    for (const int point : {1, 2}) {
        QVERIFY(!m_sensor->takeTuningPoint(point).refusal);
        m_clock->advanceMs(100);
    }
    QCOMPARE(tuningState(), 3);
    m_sensor->powerCycle();
    QCOMPARE(readNow(ItemId::BrightnessTuning), 1);
    QVERIFY(m_sensor->memory().tunedBrightness(0));
}

QTEST_GUILESS_MAIN(ProceduresTest)
#include "tst_procedures.moc"

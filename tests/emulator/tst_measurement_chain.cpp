#include "measurement_chain.h"

#include <QTest>

using namespace lds::emulator;

namespace {

Reflection at(Nanometres distance) { return {distance, 500, Light::Measurable}; }
const Reflection dark{0, 0, Light::Insufficient};

/// Nothing averaged, a window of ±1000 with hysteresis 100.
ChainSettings plain()
{
    ChainSettings settings;
    settings.averageTimes = 1;
    settings.high = 1000;
    settings.low = -1000;
    settings.hysteresis = 100;
    return settings;
}

constexpr qint64 cycleNs = 1'000'000;

/// The chain with a sample each millisecond.
class Chain : public MeasurementChain {
public:
    void sample(const Reflection& reflection, bool laserEmitting, bool trigger)
    {
        m_nowNs += cycleNs;
        MeasurementChain::sample(reflection, laserEmitting, trigger, m_nowNs);
    }
    void settle(const Reflection& reflection, bool trigger)
    {
        MeasurementChain::settle(reflection, trigger, m_nowNs);
    }

private:
    qint64 m_nowNs = 0;
};

Chain chainWith(const ChainSettings& settings)
{
    Chain chain;
    chain.setSettings(settings);
    return chain;
}

} // namespace

class MeasurementChainTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void isIndeterminateUntilTheAverageIsFull();
    void finalValueIsSpanTimesValueAfterZeroPlusOffset();
    void inversionComesBeforeZero();
    void judgmentFollowsTheSetValuesWithHysteresis();
    void triggerHoldsTheValueWhileItIsOn();
    void oneShotTakesAValueAtEachRisingEdge();
    void peakBottomAndPeakToPeakHoldExtremes();
    void extremesAreFrozenByTheTriggerAndStartAfreshAfterIt();
    void resettingForgetsAverageHeldValueAndJudgment();
    void alarmComesAfterItsDelayCount();
    void alarmNotificationCanBeOff();
    void alarmShowsTheLastValueOrTheAlarm();
    void changingTheAlarmOutputWhileUnmeasurableMakesTheValueIndeterminate();
    void aStoppedLaserMakesTheValueIndeterminate();
    void anAlarmIsHeldWithTheValueByTheTrigger();
    void losingLightChangesNothingThatTheTriggerHolds();
    void aHeldAlarmGoesWhenTheTriggerDoes();
    void anAlarmLeavesThePeakAndGoesOnAfterIt();
    void oneShotTakesAnIndeterminateValueToo();
    void judgmentOutputsStandBehindTheirTimers();
    void resettingTurnsHeldOutputsOff();
    void eachOutputHasATimerOfItsOwn();
    void changingHoldOrTriggerModeForgetsWhatIsHeld();
    void aHeldValueIsReleasedByASettingThatMakesItIndeterminate();
};

void MeasurementChainTest::isIndeterminateUntilTheAverageIsFull()
{
    ChainSettings settings = plain();
    settings.averageTimes = 4;
    Chain chain = chainWith(settings);
    for (const Nanometres distance : {100, 200, 300}) {
        chain.sample(at(distance), true, false);
        QVERIFY(!chain.value().has_value());
        QCOMPARE(chain.judgment(), Judgment::None);
    }
    chain.sample(at(400), true, false);
    QCOMPARE(chain.value(), 250);
    chain.sample(at(500), true, false);
    QCOMPARE(chain.value(), 350); // the oldest has left
    settings.averageTimes = 16;
    chain.setSettings(settings);
    QVERIFY(!chain.value().has_value()); // §4.3.2
}

void MeasurementChainTest::finalValueIsSpanTimesValueAfterZeroPlusOffset()
{
    ChainSettings settings = plain();
    settings.span = 25'000;
    settings.offset = 7;
    settings.zeroCorrection = 100;
    Chain chain = chainWith(settings);
    chain.sample(at(300), true, false);
    QCOMPARE(chain.value(), 507); // (300 − 100) × 2.5 + 7
    QCOMPARE(chain.beforeZero(), 300);
}

void MeasurementChainTest::inversionComesBeforeZero()
{
    ChainSettings settings = plain();
    settings.inverted = true;
    settings.zeroCorrection = 100; // keeps its sign (§4.3.5)
    Chain chain = chainWith(settings);
    chain.sample(at(300), true, false);
    QCOMPARE(chain.value(), -400);
}

void MeasurementChainTest::judgmentFollowsTheSetValuesWithHysteresis()
{
    Chain chain = chainWith(plain());
    const auto judge = [&chain](Nanometres distance) {
        chain.sample(at(distance), true, false);
        return chain.judgment();
    };
    QCOMPARE(judge(0), Judgment::Go);
    QCOMPARE(judge(1000), Judgment::Go); // §4.4.1: HIGH when the value exceeds the set value
    QCOMPARE(judge(1001), Judgment::High);
    QCOMPARE(judge(901), Judgment::High);
    QCOMPARE(judge(900), Judgment::Go);
    QCOMPARE(judge(901), Judgment::Go);
    QCOMPARE(judge(-1000), Judgment::Go);
    QCOMPARE(judge(-1001), Judgment::Low);
    QCOMPARE(judge(-901), Judgment::Low);
    QCOMPARE(judge(-900), Judgment::Go);
    QCOMPARE(judge(-2000), Judgment::Low);
    QCOMPARE(judge(2000), Judgment::High);
}

void MeasurementChainTest::triggerHoldsTheValueWhileItIsOn()
{
    Chain chain = chainWith(plain());
    chain.sample(at(1), true, false);
    QVERIFY(!chain.holding());
    chain.sample(at(2), true, true);
    QVERIFY(chain.holding());
    chain.sample(at(2000), true, true);
    QCOMPARE(chain.value(), 2);
    QCOMPARE(chain.judgment(), Judgment::Go); // of the value that is output
    chain.sample(at(4), true, false);
    QVERIFY(!chain.holding());
    QCOMPARE(chain.value(), 4);
}

void MeasurementChainTest::oneShotTakesAValueAtEachRisingEdge()
{
    ChainSettings settings = plain();
    settings.triggerMode = TriggerMode::OneShot;
    Chain chain = chainWith(settings);
    chain.sample(at(1), true, false);
    QVERIFY(!chain.value().has_value());
    chain.sample(at(2), true, true);
    chain.sample(at(3), true, true);
    chain.sample(at(4), true, false);
    QCOMPARE(chain.value(), 2);
    QVERIFY(chain.holding());
    chain.sample(at(5), true, true);
    QCOMPARE(chain.value(), 5);
}

void MeasurementChainTest::peakBottomAndPeakToPeakHoldExtremes()
{
    const auto last = [](HoldMode mode) {
        ChainSettings settings = plain();
        settings.holdMode = mode;
        Chain chain = chainWith(settings);
        for (const Nanometres distance : {10, 70, -20, 30})
            chain.sample(at(distance), true, false);
        return chain.value().value_or(-1);
    };
    QCOMPARE(last(HoldMode::Peak), 70);
    QCOMPARE(last(HoldMode::Bottom), -20);
    QCOMPARE(last(HoldMode::PeakToPeak), 90);
    QCOMPARE(last(HoldMode::None), 30);
}

void MeasurementChainTest::extremesAreFrozenByTheTriggerAndStartAfreshAfterIt()
{
    ChainSettings settings = plain();
    settings.holdMode = HoldMode::Peak;
    Chain chain = chainWith(settings);
    chain.sample(at(50), true, false);
    chain.sample(at(90), true, true);
    QCOMPARE(chain.value(), 50);
    QVERIFY(chain.holding());
    chain.sample(at(20), true, false); // §4.3.4: initialized when the trigger goes OFF
    QCOMPARE(chain.value(), 20);
    QVERIFY(!chain.holding());
}

void MeasurementChainTest::resettingForgetsAverageHeldValueAndJudgment()
{
    ChainSettings settings = plain();
    settings.holdMode = HoldMode::Peak;
    settings.averageTimes = 4;
    Chain chain = chainWith(settings);
    chain.settle(at(5000), false);
    QCOMPARE(chain.judgment(), Judgment::High);
    chain.restart();
    QVERIFY(!chain.value().has_value());
    QCOMPARE(chain.judgment(), Judgment::None); // §4.11
    chain.settle(at(10), false);
    QCOMPARE(chain.value(), 10);
}

void MeasurementChainTest::alarmComesAfterItsDelayCount()
{
    ChainSettings settings = plain();
    settings.alarmDelayCount = 3;
    Chain chain = chainWith(settings);
    chain.sample(at(40), true, false);
    for (int i = 0; i < 3; ++i) {
        chain.sample(dark, true, false);
        QVERIFY(!chain.alarm());
        QCOMPARE(chain.value(), 40); // §4.7.1: the last value is held meanwhile
    }
    chain.sample(dark, true, false);
    QVERIFY(chain.alarm());
    chain.sample(at(41), true, false);
    QVERIFY(!chain.alarm());
    QCOMPARE(chain.value(), 41);
}

void MeasurementChainTest::alarmNotificationCanBeOff()
{
    ChainSettings settings = plain();
    settings.alarmDelayCount = 0;
    Chain chain = chainWith(settings);
    chain.sample(at(40), true, false);
    for (int i = 0; i < 1000; ++i)
        chain.sample(dark, true, false);
    QVERIFY(!chain.alarm());
    QCOMPARE(chain.value(), 40);
}

void MeasurementChainTest::alarmShowsTheLastValueOrTheAlarm()
{
    for (const bool shown : {false, true}) {
        ChainSettings settings = plain();
        settings.alarmShown = shown;
        settings.alarmDelayCount = 1;
        Chain chain = chainWith(settings);
        chain.sample(at(2000), true, false);
        chain.sample(dark, true, false);
        chain.sample(dark, true, false);
        QVERIFY(chain.alarm());
        QCOMPARE(chain.alarmShown(), shown);
        QCOMPARE(chain.value(), 2000);
        QCOMPARE(chain.judgment(), shown ? Judgment::None : Judgment::High);
    }
}

void MeasurementChainTest::changingTheAlarmOutputWhileUnmeasurableMakesTheValueIndeterminate()
{
    ChainSettings settings = plain();
    settings.alarmShown = true;
    Chain chain = chainWith(settings);
    chain.sample(at(1), true, false);
    chain.sample(dark, true, false);
    settings.alarmShown = false;
    chain.setSettings(settings);
    chain.sample(dark, true, false);
    QVERIFY(!chain.value().has_value()); // §4.7.2 note 1
    chain.sample(at(2), true, false);
    QCOMPARE(chain.value(), 2);
}

void MeasurementChainTest::aStoppedLaserMakesTheValueIndeterminate()
{
    Chain chain = chainWith(plain());
    chain.sample(at(1), true, false);
    chain.sample(at(1), false, false);
    QVERIFY(!chain.value().has_value());
    QVERIFY(!chain.alarm());
    chain.sample(at(1), true, false);
    QCOMPARE(chain.value(), 1);
}

void MeasurementChainTest::anAlarmIsHeldWithTheValueByTheTrigger() // §4.10: "Alarm" while measurable
{
    ChainSettings settings = plain();
    settings.alarmShown = true;
    settings.alarmDelayCount = 1;
    Chain chain = chainWith(settings);
    chain.sample(at(5), true, false);
    chain.sample(dark, true, false);
    chain.sample(dark, true, false);
    QVERIFY(chain.alarmShown());
    chain.sample(dark, true, true);
    chain.sample(at(6), true, true);
    QVERIFY(chain.alarm() && chain.alarmShown()); // held
    QVERIFY(!chain.alarmNow());                   // the light itself is back
    QVERIFY(chain.measurable());
    QCOMPARE(chain.judgment(), Judgment::None);
}

void MeasurementChainTest::losingLightChangesNothingThatTheTriggerHolds() // §4.10 note
{
    ChainSettings settings = plain();
    settings.alarmShown = true;
    settings.alarmDelayCount = 1;
    Chain chain = chainWith(settings);
    chain.sample(at(5), true, true);
    for (int i = 0; i < 5; ++i)
        chain.sample(dark, true, true);
    QCOMPARE(chain.value(), 5);
    QVERIFY(!chain.alarm() && !chain.alarmShown());
    QVERIFY(chain.alarmNow());
    QVERIFY(!chain.measurable());
    chain.sample(dark, true, false);
    QVERIFY(chain.alarmShown());
}

void MeasurementChainTest::aHeldAlarmGoesWhenTheTriggerDoes()
{
    ChainSettings settings = plain();
    settings.alarmDelayCount = 1;
    Chain chain = chainWith(settings);
    chain.sample(at(5), true, false);
    for (int i = 0; i < 3; ++i)
        chain.sample(dark, true, i > 1);
    QVERIFY(chain.alarm());
    chain.sample(at(7), true, true);
    QVERIFY(chain.alarm());
    QCOMPARE(chain.value(), 5);
    chain.sample(at(8), true, false);
    QVERIFY(!chain.alarm());
    QCOMPARE(chain.value(), 8);
}

void MeasurementChainTest::anAlarmLeavesThePeakAndGoesOnAfterIt()
{
    ChainSettings settings = plain();
    settings.holdMode = HoldMode::Peak;
    settings.alarmDelayCount = 1;
    Chain chain = chainWith(settings);
    chain.sample(at(50), true, false);
    chain.sample(dark, true, false);
    chain.sample(dark, true, false);
    QVERIFY(chain.alarm());
    QCOMPARE(chain.value(), 50);
    chain.sample(at(40), true, false);
    QVERIFY(!chain.alarm());
    QCOMPARE(chain.value(), 50);
    chain.sample(at(60), true, false);
    QCOMPARE(chain.value(), 60);
}

void MeasurementChainTest::oneShotTakesAnIndeterminateValueToo() // §4.6.2: it updates and holds the final
                                                                 // value
{
    ChainSettings settings = plain();
    settings.triggerMode = TriggerMode::OneShot;
    settings.averageTimes = 4;
    Chain chain = chainWith(settings);
    for (int i = 0; i < 3; ++i)
        chain.sample(at(9), true, i == 2);
    QVERIFY(chain.holding());
    QVERIFY(!chain.value());
    chain.sample(at(9), true, true);
    QVERIFY(!chain.value());
    chain.sample(at(9), true, false);
    chain.sample(at(9), true, true);
    QCOMPARE(chain.value(), 9);
}

void MeasurementChainTest::judgmentOutputsStandBehindTheirTimers() // §4.5.1, §5.2.5
{
    ChainSettings settings = plain();
    settings.outputDelay = {OutputDelay::OnDelay, 3 * cycleNs};
    Chain chain = chainWith(settings);
    chain.sample(at(2000), true, false);
    QCOMPARE(chain.judgment(), Judgment::High);
    QCOMPARE(chain.outputs(), JudgmentOutputs{});
    chain.sample(at(2000), true, false);
    chain.sample(at(2000), true, false);
    QCOMPARE(chain.outputs(), JudgmentOutputs{});
    chain.sample(at(2000), true, false);
    QCOMPARE(chain.outputs(), (JudgmentOutputs{true, false, false}));
    chain.sample(at(0), true, false);
    QCOMPARE(chain.judgment(), Judgment::Go);
    QCOMPARE(chain.outputs(), JudgmentOutputs{});
}

void MeasurementChainTest::resettingTurnsHeldOutputsOff() // §4.5.1 Hold, §4.11
{
    ChainSettings settings = plain();
    settings.outputDelay.selection = OutputDelay::Hold;
    Chain chain = chainWith(settings);
    chain.sample(at(2000), true, false);
    chain.sample(at(0), true, false);
    QCOMPARE(chain.outputs(), (JudgmentOutputs{true, true, false}));
    chain.reset();
    QCOMPARE(chain.outputs(), JudgmentOutputs{});
    chain.sample(at(0), true, false);
    QCOMPARE(chain.outputs(), (JudgmentOutputs{false, true, false}));
    settings.averageTimes = 4; // indeterminate, but no measured value resetting
    chain.setSettings(settings);
    QCOMPARE(chain.judgment(), Judgment::None);
    QCOMPARE(chain.outputs(), (JudgmentOutputs{false, true, false}));
}

void MeasurementChainTest::eachOutputHasATimerOfItsOwn() // §5.2.5 note 1 is about "at timer OFF" only
{
    ChainSettings settings = plain();
    settings.outputDelay = {OutputDelay::OffDelay, 2 * cycleNs};
    Chain chain = chainWith(settings);
    chain.sample(at(2000), true, false);
    chain.sample(at(-2000), true, false);
    QCOMPARE(chain.judgment(), Judgment::Low);
    QCOMPARE(chain.outputs(), (JudgmentOutputs{true, false, true}));
    chain.sample(at(-2000), true, false);
    chain.sample(at(-2000), true, false);
    QCOMPARE(chain.outputs(), (JudgmentOutputs{false, false, true}));
}

void MeasurementChainTest::changingHoldOrTriggerModeForgetsWhatIsHeld()
{
    ChainSettings settings = plain();
    settings.holdMode = HoldMode::Peak;
    Chain chain = chainWith(settings);
    chain.sample(at(90), true, false);
    settings.holdMode = HoldMode::Bottom;
    chain.setSettings(settings);
    QVERIFY(!chain.value());
    chain.sample(at(20), true, false);
    QCOMPARE(chain.value(), 20);
    settings.holdMode = HoldMode::None;
    settings.triggerMode = TriggerMode::OneShot;
    chain.setSettings(settings);
    QVERIFY(!chain.value() && !chain.holding());
}

void MeasurementChainTest::aHeldValueIsReleasedByASettingThatMakesItIndeterminate() // §4.6.2 note
{
    Chain chain = chainWith(plain());
    chain.sample(at(1), true, true);
    QCOMPARE(chain.value(), 1);
    ChainSettings settings = plain();
    settings.averageTimes = 4;
    chain.setSettings(settings);
    QVERIFY(!chain.value());
    for (int i = 0; i < 4; ++i)
        chain.sample(at(3), true, true);
    QCOMPARE(chain.value(), 3);
}

QTEST_APPLESS_MAIN(MeasurementChainTest)
#include "tst_measurement_chain.moc"

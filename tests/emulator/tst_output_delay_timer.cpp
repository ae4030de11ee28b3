#include "output_delay_timer.h"

#include <QTest>

using namespace lds::emulator;

namespace {

constexpr qint64 ms = 1'000'000;

OutputDelayTimer timerWith(OutputDelay selection, qint64 durationMs)
{
    OutputDelayTimer timer;
    timer.setSettings({selection, durationMs * ms});
    return timer;
}

/// What the output shows in each millisecond of a judgment drawn as "_##__": one letter a millisecond.
QByteArray shown(OutputDelayTimer timer, const QByteArray& judgment)
{
    QByteArray output;
    for (int time = 0; time < judgment.size(); ++time) {
        timer.advance(time * ms);
        timer.judge(judgment.at(time) == '#', time * ms);
        output += timer.output() ? '#' : '_';
    }
    return output;
}

} // namespace

/// §4.5.1: the timing charts, drawn.
class OutputDelayTimerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void followsTheTimingCharts_data();
    void followsTheTimingCharts();
    void holdStaysUntilItIsReset();
    void delaysBetweenSamplesEndOnTime();
    void aChangeDuringADelayCountsFromTheNextChangeOfTheOutput();
    void aSelectionChangedDuringADelayWaitsForItsEnd();
    void aChangeWithNothingUnderWayCountsAtOnce();
    void aHeldOutputOutlivesTheSelection();
    void resettingTurnsOffWhatIsUnderWay();
};

void OutputDelayTimerTest::followsTheTimingCharts_data()
{
    QTest::addColumn<OutputDelay>("selection");
    QTest::addColumn<QByteArray>("judgment");
    QTest::addColumn<QByteArray>("output");
    const auto row = [](const char* name, OutputDelay selection, const char* judgment, const char* output) {
        QTest::newRow(name) << selection << QByteArray(judgment) << QByteArray(output);
    };
    // The timer is 3 ms.
    row("off: as judged", OutputDelay::Off, "_#__##_#", "_#__##_#");
    row("on delay: late by the timer", OutputDelay::OnDelay, "_#####__", "____##__");
    row("on delay: OFF at once", OutputDelay::OnDelay, "_####_____", "____#_____");
    row("on delay: as long as the timer", OutputDelay::OnDelay, "_###_____", "_________");
    row("on delay: shorter than the timer", OutputDelay::OnDelay, "_##_##___", "_________");
    row("on delay: each ON counts anew", OutputDelay::OnDelay, "_##_#####", "_______##");
    row("off delay: late by the timer", OutputDelay::OffDelay, "_##______", "_#####___");
    row("off delay: a short OFF does not show", OutputDelay::OffDelay, "_#__##_____", "_########__");
    row("off delay: an OFF as long as the timer", OutputDelay::OffDelay, "_#___#____",
        "_####"
        "####_");
    row("one shot: as long as the timer", OutputDelay::OneShot, "_#______", "_###____");
    row("one shot: while it stays ON", OutputDelay::OneShot, "_#######", "_###____");
    row("one shot: not prolonged", OutputDelay::OneShot, "_#_#____", "_###____");
    row("one shot: again after its end", OutputDelay::OneShot, "_#___#___", "_###_###_");
    row("one shot: an edge during it is lost", OutputDelay::OneShot, "_#_######", "_###_____");
    row("hold: for good", OutputDelay::Hold, "_#______", "_#######");
}

void OutputDelayTimerTest::followsTheTimingCharts()
{
    QFETCH(OutputDelay, selection);
    QFETCH(QByteArray, judgment);
    QFETCH(QByteArray, output);
    QCOMPARE(shown(timerWith(selection, 3), judgment), output);
}

void OutputDelayTimerTest::holdStaysUntilItIsReset()
{
    OutputDelayTimer timer = timerWith(OutputDelay::Hold, 1);
    timer.judge(true, 0);
    timer.judge(false, ms);
    QVERIFY(timer.output());
    timer.reset();
    QVERIFY(!timer.output());
    timer.judge(true, 2 * ms); // the next ON holds again
    QVERIFY(timer.output());
}

void OutputDelayTimerTest::delaysBetweenSamplesEndOnTime()
{
    OutputDelayTimer timer = timerWith(OutputDelay::OnDelay, 1);
    timer.judge(true, 0);
    timer.advance(ms - 1);
    QVERIFY(!timer.output());
    timer.advance(ms);
    QVERIFY(timer.output());
}

void OutputDelayTimerTest::aChangeDuringADelayCountsFromTheNextChangeOfTheOutput()
{
    OutputDelayTimer timer = timerWith(OutputDelay::OnDelay, 10);
    timer.judge(true, 0);
    timer.setSettings({OutputDelay::OnDelay, 2 * ms});
    timer.advance(9 * ms);
    QVERIFY(!timer.output()); // still the ten
    timer.advance(10 * ms);
    QVERIFY(timer.output());
    timer.judge(false, 11 * ms);
    timer.judge(true, 12 * ms);
    timer.advance(14 * ms);
    QVERIFY(timer.output()); // now the two
}

void OutputDelayTimerTest::aSelectionChangedDuringADelayWaitsForItsEnd()
{
    OutputDelayTimer timer = timerWith(OutputDelay::OffDelay, 5);
    timer.judge(true, 0);
    timer.judge(false, ms);
    timer.setSettings({OutputDelay::Off, 5 * ms});
    timer.advance(5 * ms);
    QVERIFY(timer.output());
    timer.advance(6 * ms);
    QVERIFY(!timer.output());
    timer.judge(true, 7 * ms);
    timer.judge(false, 8 * ms);
    QVERIFY(!timer.output());
}

void OutputDelayTimerTest::aChangeWithNothingUnderWayCountsAtOnce()
{
    OutputDelayTimer timer = timerWith(OutputDelay::OneShot, 1);
    timer.judge(true, 0);
    timer.advance(ms);
    QVERIFY(!timer.output());
    timer.setSettings({OutputDelay::Off, ms});
    QVERIFY(timer.output()); // as judged
    timer.setSettings({OutputDelay::OneShot, ms});
    QVERIFY(!timer.output()); // being ON is no turning ON
}

void OutputDelayTimerTest::aHeldOutputOutlivesTheSelection()
{
    OutputDelayTimer timer = timerWith(OutputDelay::Hold, 1);
    timer.judge(true, 0);
    timer.setSettings({OutputDelay::Off, ms});
    timer.judge(false, ms);
    QVERIFY(timer.output());
    timer.reset();
    timer.judge(true, 2 * ms);
    timer.judge(false, 3 * ms);
    QVERIFY(!timer.output());
}

void OutputDelayTimerTest::resettingTurnsOffWhatIsUnderWay() // §4.11
{
    for (const OutputDelay selection :
         {OutputDelay::OnDelay, OutputDelay::OffDelay, OutputDelay::OneShot, OutputDelay::Hold}) {
        OutputDelayTimer timer = timerWith(selection, 5);
        timer.judge(true, 0);
        timer.judge(false, ms);
        timer.reset();
        QVERIFY(!timer.output());
        timer.advance(100 * ms);
        QVERIFY(!timer.output());
    }
}

QTEST_APPLESS_MAIN(OutputDelayTimerTest)
#include "tst_output_delay_timer.moc"

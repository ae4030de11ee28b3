// §4.5: the timing charts at the three outputs of the sensor; the timer alone is in tst_output_delay_timer.
#include "manual_items.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

enum Selection { TimerOff = 0, OnDelay = 1, OffDelay = 2, OneShot = 3, HoldOutput = 4 }; // Register 400122

struct Output {
    const char* name;
    int coil;
    int timerOffCoil;
    Value on;  ///< A place that is judged so,
    Value off; ///< and one that is not.
};
constexpr Output outputs[] = {{"HI", High, TimerOffHigh, 60'000, 0},
                              {"GO", Go, TimerOffGo, 0, 60'000},
                              {"LO", Low, TimerOffLow, -60'000, 0}};

} // namespace

class ManualOutputDelayTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void timingChart_data();
    void timingChart();
    void severalOutputsMayBeOnAtOnce();
    void resettingReleasesHold();
    void aChangeMeanwhileCountsFromTheNextChangeOn();
    void theTimeMeansNothingToOffAndHold_data();
    void theTimeMeansNothingToOffAndHold();
    void theTimeIsSharedByAllSelections();

private:
    void place(Value where) { m_sensor->placeWorkpiece(where); }
    bool coil(int number)
    {
        m_sensor->catchUp();
        return m_sensor->coil(number);
    }
};

void ManualOutputDelayTest::init()
{
    setUp();
    QVERIFY(write(ItemId::AverageTimes, 0));
}

void ManualOutputDelayTest::timingChart_data()
{
    QTest::addColumn<int>("selection");
    QTest::addColumn<int>("output");
    QTest::addColumn<QByteArray>("judgment"); ///< A letter for each millisecond.
    QTest::addColumn<QByteArray>("expected");
    struct Chart {
        const char* name;
        Selection selection;
        const char* judgment;
        const char* output;
    };
    // The timer's time is 3 ms.
    const QList<Chart> charts{{"off", TimerOff, "_#__##_#_", "_#__##_#_"},
                              {"on delay", OnDelay, "_#####___", "____##___"},
                              {"on delay, too short", OnDelay, "_##_#____", "_________"},
                              {"off delay", OffDelay, "_##______", "_#####___"},
                              {"off delay, too short", OffDelay, "_#__#_____", "_#######__"},
                              {"one shot", OneShot, "_#_______", "_###_____"},
                              {"one shot, not prolonged", OneShot, "_#_#_____", "_###_____"},
                              {"one shot, longer judgment", OneShot, "_######__", "_###_____"},
                              {"hold", HoldOutput, "_#_______", "_########"}};
    for (const Chart& chart : charts) {
        for (int output = 0; output < int(std::size(outputs)); ++output)
            QTest::addRow("%s at %s", chart.name, outputs[output].name)
                << int(chart.selection) << output << QByteArray(chart.judgment) << QByteArray(chart.output);
    }
}

void ManualOutputDelayTest::timingChart()
{
    QFETCH(int, selection);
    QFETCH(int, output);
    QFETCH(QByteArray, judgment);
    QFETCH(QByteArray, expected);
    const Output& at = outputs[output];
    place(at.off);
    m_clock->advanceMs(10);
    QVERIFY(write(ItemId::OutputDelayTimerSetting, 3));
    QVERIFY(write(ItemId::OutputDelayTimerSelection, selection));
    QByteArray shown;
    QByteArray atTimerOff;
    for (const char letter : judgment) {
        m_clock->advanceMs(1);
        place(letter == '#' ? at.on : at.off);
        shown += coil(at.coil) ? '#' : '_';
        atTimerOff += coil(at.timerOffCoil) ? '#' : '_';
    }
    QCOMPARE(shown, expected);
    QCOMPARE(atTimerOff, judgment);
}

void ManualOutputDelayTest::severalOutputsMayBeOnAtOnce()
{
    QVERIFY(write(ItemId::OutputDelayTimerSetting, 3));
    QVERIFY(write(ItemId::OutputDelayTimerSelection, OffDelay));
    place(0);
    m_clock->advanceMs(10);
    place(60'000);
    QVERIFY(coil(Go) && coil(High) && !coil(Low)); // GO is late to go
    QVERIFY(!coil(TimerOffGo) && coil(TimerOffHigh) && !coil(TimerOffLow));
    m_clock->advanceMs(1);
    place(-60'000);
    QVERIFY(coil(Go) && coil(High) && coil(Low));
    QVERIFY(!coil(TimerOffGo) && !coil(TimerOffHigh) && coil(TimerOffLow));
    m_clock->advanceMs(2);
    QVERIFY(!coil(Go) && coil(High) && coil(Low));
    m_clock->advanceMs(1);
    QVERIFY(!coil(Go) && !coil(High) && coil(Low));
}

void ManualOutputDelayTest::resettingReleasesHold()
{
    QVERIFY(write(ItemId::AverageTimes, 1)); // 4 samples of 1 ms
    QVERIFY(write(ItemId::OutputDelayTimerSelection, HoldOutput));
    for (const Value where : {60'000, -60'000, 0}) {
        place(where);
        m_clock->advanceMs(200);
    }
    QVERIFY(coil(High) && coil(Go) && coil(Low));
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    QVERIFY(!coil(High) && !coil(Go) && !coil(Low));
    m_clock->advanceMs(5);
    QVERIFY(!coil(High) && coil(Go) && !coil(Low)); // sensing has started again
}

void ManualOutputDelayTest::aChangeMeanwhileCountsFromTheNextChangeOn()
{
    QVERIFY(write(ItemId::OutputDelayTimerSetting, 50));
    QVERIFY(write(ItemId::OutputDelayTimerSelection, OnDelay));
    place(0);
    m_clock->advanceMs(100);
    place(60'000);
    m_clock->advanceMs(10);
    QVERIFY(write(ItemId::OutputDelayTimerSetting, 5));
    m_clock->advanceMs(39);
    QVERIFY(!coil(High)); // still the 50 ms
    m_clock->advanceMs(1);
    QVERIFY(coil(High));
    place(0);
    QVERIFY(!coil(High));
    m_clock->advanceMs(20);
    place(60'000);
    m_clock->advanceMs(4);
    QVERIFY(!coil(High));
    m_clock->advanceMs(1);
    QVERIFY(coil(High)); // now the 5 ms
}

void ManualOutputDelayTest::theTimeMeansNothingToOffAndHold_data()
{
    QTest::addColumn<int>("selection");
    QTest::newRow("off") << int(TimerOff);
    QTest::newRow("hold") << int(HoldOutput);
}

void ManualOutputDelayTest::theTimeMeansNothingToOffAndHold()
{
    QFETCH(int, selection);
    place(0);
    QVERIFY(write(ItemId::OutputDelayTimerSetting, 100));
    QVERIFY(write(ItemId::OutputDelayTimerSelection, selection));
    QVERIFY(!coil(High));
    place(60'000);
    QVERIFY(coil(High));
    place(0);
    QCOMPARE(coil(High), selection == HoldOutput);
    m_clock->advanceMs(1'000);
    QCOMPARE(coil(High), selection == HoldOutput);
}

void ManualOutputDelayTest::theTimeIsSharedByAllSelections()
{
    place(0);
    QVERIFY(write(ItemId::OutputDelayTimerSetting, 7));
    for (const Selection selection : {OnDelay, OffDelay, OneShot}) {
        QVERIFY(write(ItemId::OutputDelayTimerSelection, selection));
        QCOMPARE(readNow(ItemId::OutputDelayTimerSetting), 7);
        m_clock->advanceMs(20);
        place(60'000);
        if (selection == OffDelay)
            place(0);
        m_clock->advanceMs(6);
        QCOMPARE(coil(High), selection != OnDelay);
        m_clock->advanceMs(1);
        QCOMPARE(coil(High), selection == OnDelay);
        place(0);
        m_clock->advanceMs(20);
    }
}

QTEST_GUILESS_MAIN(ManualOutputDelayTest)
#include "tst_manual_output_delay.moc"

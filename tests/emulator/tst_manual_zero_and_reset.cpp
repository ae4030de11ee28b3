// §4.10 Zero Setting and §4.11 Measured Value Resetting.
#include "manual_items.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

constexpr Value indeterminate = -9'999'999;

/// The rows of the table of §4.10: what the sensor displays.
enum class Display { Inside, Outside, Alarm, Indeterminate };

} // namespace

class ManualZeroAndResetTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void zeroMakesThePlaceZeroAndMovesEveryOther();
    void zeroWithAnOffsetShowsTheOffset();
    void zeroOffShowsThePlacesAgain();
    void zeroAgainTakesTheNewPlace();
    void inversionAfterZeroLeavesZero();
    void whetherZeroCanBeSet_data();
    void whetherZeroCanBeSet();
    void aHeldValueDoesNotMakeZeroPossible();

    void resettingStartsTheAverageAgain();
    void resettingForgetsWhatIsHeld_data();
    void resettingForgetsWhatIsHeld();
    void resettingTurnsEveryJudgmentOutputOff_data();
    void resettingTurnsEveryJudgmentOutputOff();
};

void ManualZeroAndResetTest::zeroMakesThePlaceZeroAndMovesEveryOther()
{
    m_sensor->placeWorkpiece(12'345);
    QCOMPARE(readNow(ItemId::ZeroSetting), 0);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QCOMPARE(value(), 0);
    QCOMPARE(readNow(ItemId::ZeroSetting), 1);
    QVERIFY(m_sensor->coil(Zero));
    for (const Value place : {12'346, 0, -20'000}) {
        m_sensor->placeWorkpiece(place);
        QCOMPARE(value(), place - 12'345);
    }
}

void ManualZeroAndResetTest::zeroWithAnOffsetShowsTheOffset()
{
    QVERIFY(write(ItemId::Offset, -777));
    QVERIFY(write(ItemId::Span, 20'000));
    m_sensor->placeWorkpiece(12'345);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QCOMPARE(value(), -777);
}

void ManualZeroAndResetTest::zeroOffShowsThePlacesAgain()
{
    m_sensor->placeWorkpiece(500);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QVERIFY(write(ItemId::ZeroSetting, 0));
    QCOMPARE(value(), 500);
    QCOMPARE(readNow(ItemId::ZeroSetting), 0);
    QVERIFY(!m_sensor->coil(Zero));
}

void ManualZeroAndResetTest::zeroAgainTakesTheNewPlace()
{
    m_sensor->placeWorkpiece(500);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    m_sensor->placeWorkpiece(800);
    QCOMPARE(value(), 300);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QCOMPARE(value(), 0);
    QVERIFY(write(ItemId::ZeroSetting, 0));
    QCOMPARE(value(), 800);
}

void ManualZeroAndResetTest::inversionAfterZeroLeavesZero()
{
    m_sensor->placeWorkpiece(500);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QCOMPARE(value(), 0);
    QVERIFY(write(ItemId::InversionOfMeasuredValue, 1));
    m_clock->advanceMs(averageFullMs);
    QVERIFY(value() != 0);
    QVERIFY(write(ItemId::ZeroSetting, 1)); // "make an adjustment again"
    QCOMPARE(value(), 0);
}

void ManualZeroAndResetTest::whetherZeroCanBeSet_data()
{
    QTest::addColumn<int>("display");
    QTest::addColumn<bool>("measurable");
    const QList<std::pair<const char*, Display>> displays{{"inside the range", Display::Inside},
                                                          {"outside the range", Display::Outside},
                                                          {"alarm", Display::Alarm},
                                                          {"indeterminate", Display::Indeterminate}};
    for (const auto& [name, display] : displays) {
        QTest::addRow("%s, measurable", name) << int(display) << true;
        QTest::addRow("%s, unmeasurable", name) << int(display) << false;
    }
}

/// The trigger holds what is displayed, so that the light may be otherwise: an alarm over measurable light.
void ManualZeroAndResetTest::whetherZeroCanBeSet()
{
    QFETCH(int, display);
    QFETCH(bool, measurable);
    QVERIFY(write(ItemId::AverageTimes, 0));
    QVERIFY(write(ItemId::AlarmDigitalOutput, display == int(Display::Alarm)));
    m_sensor->placeWorkpiece(display == int(Display::Outside) ? 60'000 : 700);
    m_sensor->setFault(SensorFault::NoLight, display == int(Display::Alarm));
    m_clock->advanceMs(20);
    QVERIFY(write(ItemId::TriggerInputCommunication, 1)); // from now on displayed: this
    m_sensor->setFault(SensorFault::NoLight, !measurable);
    m_clock->advanceMs(20);
    if (display == int(Display::Indeterminate)) {
        QVERIFY(write(ItemId::TriggerInputCommunication, 0));
        QVERIFY(write(ItemId::AverageTimes, 5));
        m_clock->advanceMs(5);
    }
    const Value shown = display == int(Display::Alarm)           ? 9'999'999
                        : display == int(Display::Indeterminate) ? indeterminate
                        : display == int(Display::Outside)       ? 60'000
                                                                 : 700;
    QCOMPARE(value(), shown);
    const WriteOutcome outcome = m_sensor->write({{ItemId::ZeroSetting, 1}});
    QCOMPARE(!outcome.refusal, measurable);
    QCOMPARE(readNow(ItemId::ZeroSetting), measurable ? 1 : 0);
    if (!measurable)
        QCOMPARE(outcome.refusal, Refusal::Failed); // 04 over Modbus
}

void ManualZeroAndResetTest::aHeldValueDoesNotMakeZeroPossible()
{
    m_sensor->placeWorkpiece(700);
    QVERIFY(write(ItemId::AlarmDelayCount, 1'000));
    m_sensor->setFault(SensorFault::NoLight, true);
    m_clock->advanceMs(5);
    QCOMPARE(value(), 700); // shown by the alarm delay
    QVERIFY(!write(ItemId::ZeroSetting, 1));
    QVERIFY(write(ItemId::ZeroSetting, 0)); // clearing needs no light
}

void ManualZeroAndResetTest::resettingStartsTheAverageAgain()
{
    QVERIFY(write(ItemId::AverageTimes, 3)); // 64 samples of 1 ms
    m_sensor->placeWorkpiece(700);
    QCOMPARE(value(), 700);
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    QCOMPARE(value(), indeterminate);
    m_clock->advanceMs(63);
    QCOMPARE(value(), indeterminate);
    m_clock->advanceMs(1);
    QCOMPARE(value(), 700);
}

void ManualZeroAndResetTest::resettingForgetsWhatIsHeld_data()
{
    QTest::addColumn<int>("holdMode");
    QTest::addColumn<int>("held");
    QTest::addColumn<int>("after");
    QTest::newRow("peak") << 1 << 900 << 100;
    QTest::newRow("bottom") << 2 << -900 << 100;
    QTest::newRow("peak to peak") << 3 << 1'800 << 0;
}

void ManualZeroAndResetTest::resettingForgetsWhatIsHeld()
{
    QFETCH(int, holdMode);
    QFETCH(int, held);
    QFETCH(int, after);
    QVERIFY(write(ItemId::AverageTimes, 0));
    QVERIFY(write(ItemId::HoldMode, holdMode));
    for (const Value place : {900, -900, 100})
        m_sensor->placeWorkpiece(place);
    QCOMPARE(value(), held);
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    m_clock->advanceMs(5);
    QCOMPARE(value(), after);
}

void ManualZeroAndResetTest::resettingTurnsEveryJudgmentOutputOff_data()
{
    QTest::addColumn<int>("timer");
    QTest::newRow("no timer") << 0;
    QTest::newRow("on delay") << 1;
    QTest::newRow("off delay") << 2;
    QTest::newRow("one shot") << 3;
    QTest::newRow("hold") << 4;
}

void ManualZeroAndResetTest::resettingTurnsEveryJudgmentOutputOff()
{
    QFETCH(int, timer);
    QVERIFY(write(ItemId::AverageTimes, 1)); // so that they stay OFF for a while
    QVERIFY(write(ItemId::OutputDelayTimerSelection, timer));
    QVERIFY(write(ItemId::OutputDelayTimerSetting, 50));
    for (const Value place : {60'000, 0, -60'000}) {
        m_sensor->placeWorkpiece(place);
        m_clock->advanceMs(timer == 1 ? 60 : 1);
    }
    m_sensor->catchUp();
    QVERIFY(m_sensor->coil(High) || m_sensor->coil(Go) || m_sensor->coil(Low));
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    for (const int coil : {High, Go, Low, TimerOffHigh, TimerOffGo, TimerOffLow})
        QVERIFY(!m_sensor->coil(coil));
}

QTEST_GUILESS_MAIN(ManualZeroAndResetTest)
#include "tst_manual_zero_and_reset.moc"

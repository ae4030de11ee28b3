// §4.7 Alarm Setting: unmeasurable states, their delay, and what is output meanwhile.
#include "manual_items.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

constexpr Value alarmValue = 9'999'999;
constexpr Value indeterminate = -9'999'999;

} // namespace

class ManualAlarmTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init();

    void everyUnmeasurableStateRaisesTheAlarm_data();
    void everyUnmeasurableStateRaisesTheAlarm();
    void theDelayIsCountTimesSamplingCycle_data();
    void theDelayIsCountTimesSamplingCycle();
    void theLastValueIsHeldWhileTheAlarmIsDelayed_data();
    void theLastValueIsHeldWhileTheAlarmIsDelayed();
    void aShorterDisturbanceRaisesNoAlarm();
    void countZeroTurnsTheNotificationOff();
    void theLongestDelayIs65535Samples();

    void outputOfEveryState_data();
    void outputOfEveryState();
    void changingTheOutputWhileUnmeasurableIsIndeterminateUntilLightComesBack_data();
    void changingTheOutputWhileUnmeasurableIsIndeterminateUntilLightComesBack();

private:
    void dim() { m_sensor->setFault(SensorFault::NoLight, true); }
    void light() { m_sensor->setFault(SensorFault::NoLight, false); }
};

void ManualAlarmTest::init()
{
    setUp();
    QVERIFY(write(ItemId::AverageTimes, 0));
    m_sensor->placeWorkpiece(700);
    m_clock->advanceMs(100);
    QCOMPARE(value(), 700);
}

void ManualAlarmTest::everyUnmeasurableStateRaisesTheAlarm_data()
{
    QTest::addColumn<int>("fault");
    QTest::addColumn<int>("detail"); ///< Coil.
    QTest::newRow("excessive intensity") << int(SensorFault::Saturated) << int(ExcessiveLight);
    QTest::newRow("insufficient intensity") << int(SensorFault::NoLight) << int(InsufficientLight);
    QTest::newRow("excessive extraneous light") << int(SensorFault::AmbientLight) << int(ExtraneousLight);
}

void ManualAlarmTest::everyUnmeasurableStateRaisesTheAlarm()
{
    QFETCH(int, fault);
    QFETCH(int, detail);
    QVERIFY(write(ItemId::AlarmDigitalOutput, 1));
    m_sensor->setFault(SensorFault(fault), true);
    m_clock->advanceMs(20);
    QCOMPARE(value(), alarmValue);
    QVERIFY(m_sensor->coil(Alarm));
    for (const int each : {ExcessiveLight, InsufficientLight, ExtraneousLight})
        QCOMPARE(m_sensor->coil(each), each == detail);
    m_sensor->setFault(SensorFault(fault), false);
    m_clock->advanceMs(20);
    QCOMPARE(value(), 700);
    QVERIFY(!m_sensor->coil(Alarm) && !m_sensor->coil(detail));
}

void ManualAlarmTest::theDelayIsCountTimesSamplingCycle_data()
{
    QTest::addColumn<int>("cycle");
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("delayMs");
    QTest::newRow("100 us, 100 times") << 0 << 100 << 10;
    QTest::newRow("200 us, 100 times") << 1 << 100 << 20;
    QTest::newRow("500 us, 100 times") << 2 << 100 << 50;
    QTest::newRow("1 ms, 100 times") << 3 << 100 << 100;
    QTest::newRow("2 ms, 100 times") << 4 << 100 << 200;
    QTest::newRow("1 ms, once") << 3 << 1 << 1;
    QTest::newRow("as delivered") << 3 << 8 << 8;
}

void ManualAlarmTest::theDelayIsCountTimesSamplingCycle()
{
    QFETCH(int, cycle);
    QFETCH(int, count);
    QFETCH(int, delayMs);
    QVERIFY(write(ItemId::SamplingFrequency, cycle));
    QVERIFY(write(ItemId::AlarmDelayCount, count));
    m_clock->advanceMs(10);
    m_sensor->catchUp();
    dim();
    m_clock->advanceMs(delayMs);
    m_sensor->catchUp();
    QVERIFY(!m_sensor->coil(Alarm)); // it has to last for more than the count (§4.7.2)
    m_clock->advanceMs(2);
    m_sensor->catchUp();
    QVERIFY(m_sensor->coil(Alarm));
}

void ManualAlarmTest::theLastValueIsHeldWhileTheAlarmIsDelayed_data()
{
    QTest::addColumn<int>("output");
    QTest::newRow("Hold") << 0;
    QTest::newRow("Alarm") << 1;
}

void ManualAlarmTest::theLastValueIsHeldWhileTheAlarmIsDelayed()
{
    QFETCH(int, output);
    QVERIFY(write(ItemId::AlarmDigitalOutput, output));
    dim();
    m_clock->advanceMs(8);
    QCOMPARE(value(), 700);
    QVERIFY(!m_sensor->coil(Alarm) && !m_sensor->coil(Indeterminate) && m_sensor->coil(Go));
    QVERIFY(!m_sensor->coil(Notification) && !m_sensor->coil(InsufficientLight));
}

void ManualAlarmTest::aShorterDisturbanceRaisesNoAlarm()
{
    for (int round = 0; round < 5; ++round) { // the samples of different disturbances do not add up
        dim();
        m_clock->advanceMs(7);
        m_sensor->catchUp();
        QVERIFY(!m_sensor->coil(Alarm));
        light();
        m_clock->advanceMs(2);
        m_sensor->catchUp();
    }
}

void ManualAlarmTest::countZeroTurnsTheNotificationOff()
{
    QVERIFY(write(ItemId::AlarmDelayCount, 0));
    QVERIFY(write(ItemId::AlarmDigitalOutput, 1));
    dim();
    m_clock->advanceMs(90'000);
    QCOMPARE(value(), 700);
    for (const int coil : {Alarm, Indeterminate, Notification, InsufficientLight})
        QVERIFY(!m_sensor->coil(coil));
}

void ManualAlarmTest::theLongestDelayIs65535Samples()
{
    QVERIFY(write(ItemId::AlarmDelayCount, 65'535));
    dim();
    m_clock->advanceMs(65'535);
    m_sensor->catchUp();
    QVERIFY(!m_sensor->coil(Alarm));
    m_clock->advanceMs(1);
    m_sensor->catchUp();
    QVERIFY(m_sensor->coil(Alarm));
}

void ManualAlarmTest::outputOfEveryState_data()
{
    QTest::addColumn<int>("output"); ///< Alarm digital output.
    QTest::addColumn<int>("place");
    QTest::addColumn<bool>("alarm");
    QTest::addColumn<int>("read");
    for (const int output : {0, 1}) {
        QTest::addRow("output %d, above HIGH", output) << output << 60'000 << false << 60'000;
        QTest::addRow("output %d, at HIGH", output) << output << 50'000 << false << 50'000;
        QTest::addRow("output %d, at LOW", output) << output << -50'000 << false << -50'000;
        QTest::addRow("output %d, below LOW", output) << output << -60'000 << false << -60'000;
        QTest::addRow("output %d, alarm", output)
            << output << 60'000 << true << (output == 0 ? 60'000 : alarmValue);
    }
}

void ManualAlarmTest::outputOfEveryState()
{
    QFETCH(int, output);
    QFETCH(int, place);
    QFETCH(bool, alarm);
    QFETCH(int, read);
    QVERIFY(write(ItemId::AlarmDigitalOutput, output));
    m_sensor->placeWorkpiece(place);
    m_sensor->setFault(SensorFault::NoLight, alarm);
    m_clock->advanceMs(20);
    QCOMPARE(value(), read);
    QCOMPARE(m_sensor->coil(Alarm), alarm);
    QVERIFY(!m_sensor->coil(Indeterminate));
    QVERIFY(write(ItemId::LaserStop, 1)); // and indeterminate, whatever the setting
    QCOMPARE(value(), indeterminate);
    QVERIFY(m_sensor->coil(Indeterminate));
}

void ManualAlarmTest::changingTheOutputWhileUnmeasurableIsIndeterminateUntilLightComesBack_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("afterMs");
    QTest::newRow("Hold to Alarm, while delayed") << 0 << 3;
    QTest::newRow("Hold to Alarm, in alarm") << 0 << 30;
    QTest::newRow("Alarm to Hold, while delayed") << 1 << 3;
    QTest::newRow("Alarm to Hold, in alarm") << 1 << 30;
}

void ManualAlarmTest::changingTheOutputWhileUnmeasurableIsIndeterminateUntilLightComesBack()
{
    QFETCH(int, from);
    QFETCH(int, afterMs);
    QVERIFY(write(ItemId::AlarmDigitalOutput, from));
    dim();
    m_clock->advanceMs(afterMs);
    QVERIFY(write(ItemId::AlarmDigitalOutput, 1 - from));
    QCOMPARE(value(), indeterminate);
    m_clock->advanceMs(1'000);
    QCOMPARE(value(), indeterminate);
    light();
    m_clock->advanceMs(2);
    QCOMPARE(value(), 700);
}

QTEST_GUILESS_MAIN(ManualAlarmTest)
#include "tst_manual_alarm.moc"

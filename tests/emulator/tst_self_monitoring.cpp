#include "self_monitoring.h"
#include "sensor_fixture.h"
#include "trigger_line.h"

#include <QSignalSpy>
#include <QTest>

using namespace lds::catalog;
using namespace lds::emulator;
using namespace lds::test;

/// §4.13 and §8.2 at the sensor, and the trigger line's 2 ms.
class SelfMonitoringTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void cautionsComeAboveTheirLimits();
    void operatingHoursCountWhileItLives();
    void operatingHoursAreKeptEachHour();
    void everyWriteToItsMemoryCounts();
    void eachErrorCodeHasItsBit_data();
    void eachErrorCodeHasItsBit();
    void anErrorCarriesItsInternalDigits();
    void anErrorStopsMeasuring();
    void aPowerCycleHelpsAgainstWhatTheManualSays();
    void setValueInitializationHelpsAgainstTheUserMemoryError();
    void aFaultThatGoesOnComesBackAfterAPowerCycle();
    void unknownErrorCodesAreIgnored();
    void noAlarmNoNotificationOfLight();
    void aWorkpieceOutOfRangeIsNotifiedAndStillMeasured();
    void whileTheTriggerHoldsTheLightIsStillWatched();
    void aTriggerShorterThanTwoMillisecondsIsNotSeen();
    void aTriggerOfTwoMillisecondsIsSeenAtEveryCycle_data();
    void aTriggerOfTwoMillisecondsIsSeenAtEveryCycle();
};

void SelfMonitoringTest::cautionsComeAboveTheirLimits()
{
    m_sensor->setLife({SelfMonitoring::mostOperatingSeconds, SelfMonitoring::mostMemoryWrites});
    QVERIFY(!m_sensor->coil(Caution));
    m_clock->advanceMs(1000);
    m_sensor->catchUp();
    QVERIFY(m_sensor->coil(33) && m_sensor->coil(Caution) && m_sensor->coil(Notification));
    QVERIFY(!m_sensor->coil(WritesExceeded));
    QVERIFY(write(ItemId::SetValueSaving, 0));
    QVERIFY(m_sensor->coil(WritesExceeded));
    QCOMPARE(m_sensor->read(ItemId::SelfMonitoringCaution), 3);
}

void SelfMonitoringTest::operatingHoursCountWhileItLives()
{
    m_clock->advanceMs(10'500);
    QCOMPARE(m_sensor->life().operatingSeconds, 10);
    m_sensor->powerCycle();
    m_clock->advanceMs(600);
    QCOMPARE(m_sensor->life().operatingSeconds, 11);
}

void SelfMonitoringTest::operatingHoursAreKeptEachHour()
{
    QList<LifeCounters> stored;
    m_sensor->setLife({3'598, 4});
    m_sensor->setStore(
        [&stored](const SettingsMemory&, const LifeCounters& life) -> tl::expected<void, QString> {
            stored.append(life);
            return {};
        });
    m_clock->advanceMs(1'000);
    QVERIFY(stored.isEmpty());
    m_clock->advanceMs(1'000);
    QCOMPARE(stored, (QList<LifeCounters>{{3'600, 4}}));
    QCOMPARE(m_sensor->memoryWriteCount(), 0); // no write of settings
}

void SelfMonitoringTest::everyWriteToItsMemoryCounts()
{
    QVERIFY(write(ItemId::SetValueSaving, 0));
    QVERIFY(write(ItemId::BankCopy, 0));
    QVERIFY(write(ItemId::SettingsInitialization, 5));
    m_sensor->changeByKeypad(ItemId::EcoMode, 0);
    QVERIFY(write(ItemId::EcoMode, 1)); // not written to memory
    QCOMPARE(m_sensor->life().memoryWrites, 4);
    m_sensor->powerCycle();
    QCOMPARE(m_sensor->life().memoryWrites, 4);
}

void SelfMonitoringTest::eachErrorCodeHasItsBit_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<int>("value");
    QTest::addColumn<int>("coil");
    for (const int code : {100, 110, 120, 130, 131, 140, 150})
        QTest::addRow("E%d", code) << code << QString::number(code).toInt(nullptr, 16) << int(SystemError);
    QTest::newRow("E200") << 200 << 0x0200 << int(BeamError);
}

void SelfMonitoringTest::eachErrorCodeHasItsBit()
{
    QFETCH(int, code);
    QFETCH(int, value);
    QFETCH(int, coil);
    m_sensor->raiseError({quint16(code), 7});
    QCOMPARE(readNow(ItemId::ErrorCode), value);
    for (int each = 49; each <= 64; ++each)
        QCOMPARE(m_sensor->coil(each), each == coil);
    QVERIFY(m_sensor->coil(Error) && m_sensor->coil(Notification) && !m_sensor->coil(Caution));
}

void SelfMonitoringTest::anErrorCarriesItsInternalDigits()
{
    m_sensor->raiseError({120, 42});
    QCOMPARE(m_sensor->error(), (ErrorState{120, 42}));
    m_sensor->raiseError({200, 1});
    QCOMPARE(m_sensor->error(), (ErrorState{120, 42})); // the first is shown
}

void SelfMonitoringTest::anErrorStopsMeasuring()
{
    m_sensor->raiseError({120, 0});
    QCOMPARE(value(), -9'999'999);
    QVERIFY(m_sensor->coil(Indeterminate) && m_sensor->coil(Laser));
    m_sensor->raiseError({200, 0});
    QVERIFY(!m_sensor->coil(Laser));
}

void SelfMonitoringTest::aPowerCycleHelpsAgainstWhatTheManualSays() // §8.2
{
    for (const quint16 code : SelfMonitoring::codes()) {
        setUp();
        m_sensor->raiseError({code, 0});
        m_sensor->powerCycle();
        QCOMPARE(m_sensor->error().code, code == 131 || code == 200 ? code : quint16(0));
    }
}

void SelfMonitoringTest::setValueInitializationHelpsAgainstTheUserMemoryError() // §8.2 E131
{
    m_sensor->raiseError({131, 0});
    m_sensor->initializeSetValues();
    QCOMPARE(m_sensor->error().code, quint16(0));
    m_clock->advanceMs(averageFullMs);
    QVERIFY(value() != -9'999'999);
}

void SelfMonitoringTest::aFaultThatGoesOnComesBackAfterAPowerCycle()
{
    m_sensor->setFault(SensorFault::SystemError, true);
    m_sensor->powerCycle();
    QCOMPARE(readNow(ItemId::ErrorCode), 0x0120);
    m_sensor->setFault(SensorFault::SystemError, false);
    QCOMPARE(readNow(ItemId::ErrorCode), 0);
}

void SelfMonitoringTest::unknownErrorCodesAreIgnored()
{
    m_sensor->raiseError({99, 0});
    QCOMPARE(m_sensor->error(), ErrorState{});
    QCOMPARE(m_sensor->stateWord(3), quint16(0));
}

void SelfMonitoringTest::noAlarmNoNotificationOfLight() // §4.7.1: delay count 0
{
    QVERIFY(write(ItemId::AlarmDelayCount, 0));
    m_sensor->setFault(SensorFault::NoLight, true);
    m_clock->advanceMs(5'000);
    QVERIFY(!m_sensor->coil(Alarm) && !m_sensor->coil(InsufficientLight) && !m_sensor->coil(Notification));
    QVERIFY(value() != -9'999'999); // the last one
}

void SelfMonitoringTest::aWorkpieceOutOfRangeIsNotifiedAndStillMeasured()
{
    m_sensor->setFault(SensorFault::OutOfRange, true);
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(value(), 75'000); // 1.5 times the 5 mm
    QVERIFY(m_sensor->coil(OutsideRange) && !m_sensor->coil(Alarm));
    m_sensor->setFault(SensorFault::OutOfRange, false);
    m_clock->advanceMs(averageFullMs);
    m_sensor->catchUp();
    QVERIFY(!m_sensor->coil(OutsideRange));
}

void SelfMonitoringTest::whileTheTriggerHoldsTheLightIsStillWatched()
{
    m_sensor->placeWorkpiece(100);
    QVERIFY(write(ItemId::TriggerInputCommunication, 1));
    m_sensor->setFault(SensorFault::Saturated, true);
    m_clock->advanceMs(50);
    QCOMPARE(value(), 100);
    QVERIFY(!m_sensor->coil(Alarm));         // the held value is none of an alarm
    QVERIFY(m_sensor->coil(ExcessiveLight)); // but an alarm has occurred
    QVERIFY(!write(ItemId::ZeroSetting, 1)); // §4.10
}

void SelfMonitoringTest::aTriggerShorterThanTwoMillisecondsIsNotSeen() // §4.6.2
{
    TriggerLine line;
    line.set(true, 0);
    QVERIFY(!line.at(1'999'999));
    line.set(false, 1'999'999);
    QVERIFY(!line.at(10'000'000));
    line.set(true, 20'000'000);
    QVERIFY(!line.at(21'000'000));
    QVERIFY(line.at(22'000'000));
    line.set(false, 30'000'000);
    QVERIFY(line.at(31'999'999));
    QVERIFY(!line.at(32'000'000));
}

void SelfMonitoringTest::aTriggerOfTwoMillisecondsIsSeenAtEveryCycle_data()
{
    QTest::addColumn<int>("cycle");
    for (int cycle = 0; cycle <= 4; ++cycle)
        QTest::addRow("cycle %d", cycle) << cycle;
}

void SelfMonitoringTest::aTriggerOfTwoMillisecondsIsSeenAtEveryCycle()
{
    QFETCH(int, cycle);
    QVERIFY(write(ItemId::SamplingFrequency, cycle));
    QVERIFY(write(ItemId::AverageTimes, 0));
    QVERIFY(write(ItemId::TriggerMode, 1));
    m_clock->advanceMs(7);
    QVERIFY(m_sensor->coil(Indeterminate));
    m_sensor->setExternalTrigger(true);
    m_clock->advanceMs(2);
    m_sensor->setExternalTrigger(false);
    m_clock->advanceMs(10);
    QVERIFY(value() != -9'999'999);
    QVERIFY(m_sensor->coil(Hold));
}

QTEST_GUILESS_MAIN(SelfMonitoringTest)
#include "tst_self_monitoring.moc"

#include "sensor_fixture.h"

#include <QSignalSpy>
#include <QTest>

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

class SensorStateTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void aMovingWorkpieceLivesInsideTheMeasurementRange_data();
    void aMovingWorkpieceLivesInsideTheMeasurementRange();
    void theSameMomentAlwaysShowsTheSameValue();
    void aPlacedWorkpieceStandsStill();
    void valuesBeyondTheDisplayRangeReadAsSentinels();
    void judgmentBitsFollowTheValue();
    void outsideTheMeasurementRangeIsToldByTheRawValue();
    void aStoppedLaserIsIndeterminateAndTold();
    void anAlarmReadsAsTheLastValueOrTheSentinel();
    void eachKindOfBadLightHasItsCoil();
    void selfMonitoringSummariesFollowTheDetails();
    void reservedBitsMayReadAsOnes();
    void everyCoilUsedIsNamedInTheCatalog();
};

void SensorStateTest::aMovingWorkpieceLivesInsideTheMeasurementRange_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("range");
    // §4.13, in 0.1 µm
    QTest::newRow("30 mm") << int(SensorModel::HlG203) << 50'000;
    QTest::newRow("50 mm") << int(SensorModel::HlG205) << 100'000;
    QTest::newRow("85 mm") << int(SensorModel::HlG208) << 200'000;
    QTest::newRow("120 mm") << int(SensorModel::HlG212) << 300'000;
    QTest::newRow("250 mm") << int(SensorModel::HlG225) << 1'500'000;
}

void SensorStateTest::aMovingWorkpieceLivesInsideTheMeasurementRange()
{
    QFETCH(int, model);
    QFETCH(int, range);
    VirtualSensor& sensor = make(SensorModel(model));
    QVERIFY(write(ItemId::AverageTimes, 0));
    Value lowest = range;
    Value highest = -range;
    for (int i = 0; i < 300; ++i) {
        m_clock->advanceMs(100);
        const Value now = value();
        QVERIFY(std::abs(now) < range);
        lowest = std::min(lowest, now);
        highest = std::max(highest, now);
        const Value intensity = sensor.read(ItemId::PeakIntensity);
        QVERIFY(intensity > 0 && intensity <= 1023);
        QVERIFY(!sensor.coil(OutsideRange) && !sensor.coil(Notification));
    }
    QVERIFY(highest - lowest > range / 2);
}

void SensorStateTest::theSameMomentAlwaysShowsTheSameValue()
{
    ManualClock otherClock;
    VirtualSensor other(SensorModel::HlG203, otherClock);
    m_clock->advanceMs(1000);
    for (int i = 0; i < 100; ++i) { // asked more often, it says the same
        otherClock.advanceMs(10);
        other.catchUp();
    }
    QCOMPARE(value(), other.read(ItemId::MeasuredValue));
    m_clock->advanceMs(1000);
    QVERIFY(value() != other.read(ItemId::MeasuredValue));
}

void SensorStateTest::aPlacedWorkpieceStandsStill()
{
    m_sensor->placeWorkpiece(-1234);
    QCOMPARE(value(), -1234);
    m_clock->advanceMs(5000);
    QCOMPARE(value(), -1234);
    m_sensor->letWorkpieceMove();
    m_clock->advanceMs(5000);
    QVERIFY(value() != -1234);
}

void SensorStateTest::valuesBeyondTheDisplayRangeReadAsSentinels()
{
    QVERIFY(write(ItemId::Offset, 90'000));
    m_sensor->placeWorkpiece(5'000);
    QCOMPARE(value(), 95'000);
    m_sensor->placeWorkpiece(5'001);
    QCOMPARE(value(), 9'600'000);
    QVERIFY(write(ItemId::Offset, -90'000));
    m_sensor->placeWorkpiece(-5'000);
    QCOMPARE(value(), -95'000);
    m_sensor->placeWorkpiece(-5'001);
    QCOMPARE(value(), -9'600'000);
    QVERIFY(m_sensor->coil(Low)); // it is judged all the same
}

void SensorStateTest::judgmentBitsFollowTheValue()
{
    const auto expectOnly = [this](int timerBit, int plainBit) {
        m_sensor->catchUp();
        for (const int coil : {High, Go, Low, TimerOffHigh, TimerOffGo, TimerOffLow})
            QCOMPARE(m_sensor->coil(coil), coil == timerBit || coil == plainBit);
    };
    QVERIFY(write(ItemId::HighSetValue, 1'000));
    QVERIFY(write(ItemId::LowSetValue, -1'000));
    m_sensor->placeWorkpiece(0);
    expectOnly(Go, TimerOffGo);
    m_sensor->placeWorkpiece(2'000);
    expectOnly(High, TimerOffHigh);
    m_sensor->placeWorkpiece(901); // hysteresis 100
    expectOnly(High, TimerOffHigh);
    m_sensor->placeWorkpiece(-2'000);
    expectOnly(Low, TimerOffLow);
}

void SensorStateTest::outsideTheMeasurementRangeIsToldByTheRawValue()
{
    QVERIFY(write(ItemId::Offset, -60'000));
    m_sensor->placeWorkpiece(50'000);
    QVERIFY(!m_sensor->coil(OutsideRange));
    m_sensor->placeWorkpiece(50'001);
    QVERIFY(m_sensor->coil(OutsideRange));
    QVERIFY(m_sensor->coil(Notification));
    QCOMPARE(m_sensor->read(ItemId::SelfMonitoringNotification), 4);
    QCOMPARE(value(), -9'999); // the measured value itself is well inside
}

void SensorStateTest::aStoppedLaserIsIndeterminateAndTold()
{
    QVERIFY(m_sensor->coil(Laser));
    QVERIFY(write(ItemId::LaserStop, 1));
    QVERIFY(!m_sensor->coil(Laser));
    QVERIFY(m_sensor->coil(Indeterminate));
    QVERIFY(!m_sensor->coil(Go));
    QCOMPARE(value(), -9'999'999);
    QCOMPARE(m_sensor->read(ItemId::PeakIntensity), 65'535);
    m_clock->advanceMs(averageFullMs);
    QCOMPARE(value(), -9'999'999);
    QVERIFY(write(ItemId::LaserStop, 0));
    QVERIFY(m_sensor->coil(Laser));
    QCOMPARE(value(), -9'999'999);
    m_clock->advanceMs(averageFullMs);
    QVERIFY(std::abs(value()) < 50'000);
}

void SensorStateTest::anAlarmReadsAsTheLastValueOrTheSentinel()
{
    m_sensor->placeWorkpiece(700);
    m_sensor->setLight(Light::Insufficient);
    m_clock->advanceMs(8); // delay count 8
    QCOMPARE(value(), 700);
    QVERIFY(!m_sensor->coil(Alarm));
    m_clock->advanceMs(1);
    QCOMPARE(value(), 700); // Alarm digital output is on Hold
    QVERIFY(m_sensor->coil(Alarm));
    m_sensor->setLight(Light::Measurable);
    m_clock->advanceMs(1);
    QVERIFY(write(ItemId::AlarmDigitalOutput, 1));
    m_sensor->setLight(Light::Insufficient);
    m_clock->advanceMs(20);
    QCOMPARE(value(), 9'999'999);
    QVERIFY(m_sensor->coil(Alarm));
    for (const int coil : {Indeterminate, High, Go, Low})
        QVERIFY(!m_sensor->coil(coil));
    m_sensor->setLight(Light::Measurable);
    m_clock->advanceMs(1);
    QCOMPARE(value(), 700);
    QVERIFY(!m_sensor->coil(Alarm));
}

void SensorStateTest::eachKindOfBadLightHasItsCoil()
{
    const QList<std::pair<Light, int>> kinds{{Light::Excessive, ExcessiveLight},
                                             {Light::Insufficient, InsufficientLight},
                                             {Light::ExtraneousLight, ExtraneousLight}};
    for (const auto& [light, coil] : kinds) {
        m_sensor->setLight(light);
        m_clock->advanceMs(20);
        m_sensor->catchUp();
        for (const auto& kind : kinds)
            QCOMPARE(m_sensor->coil(kind.second), kind.second == coil);
        QVERIFY(m_sensor->coil(Notification));
        QVERIFY(!m_sensor->coil(Caution));
        m_sensor->setLight(Light::Measurable);
        m_clock->advanceMs(20);
        m_sensor->catchUp();
        QVERIFY(!m_sensor->coil(Notification));
    }
}

void SensorStateTest::selfMonitoringSummariesFollowTheDetails()
{
    m_sensor->setLife({0, SelfMonitoring::mostMemoryWrites + 1});
    QVERIFY(m_sensor->coil(WritesExceeded) && m_sensor->coil(Caution) && m_sensor->coil(Notification));
    QVERIFY(!m_sensor->coil(Error));
    QCOMPARE(m_sensor->stateWord(2), quint16(0x0002));
    m_sensor->setFault(SensorFault::LaserCircuitError, true);
    QVERIFY(m_sensor->coil(BeamError) && m_sensor->coil(Error) && m_sensor->coil(Notification));
    QVERIFY(!m_sensor->coil(Caution)); // only while there is no error
    QCOMPARE(m_sensor->read(ItemId::ErrorCode), 0x0200);
    m_sensor->setFault(SensorFault::SystemError, true);
    QVERIFY(m_sensor->coil(SystemError));
    QCOMPARE(m_sensor->stateWord(3), quint16(0x0005));
    m_sensor->setFault(SensorFault::LaserCircuitError, false);
    m_sensor->setFault(SensorFault::SystemError, false);
    QVERIFY(m_sensor->coil(Caution));
    m_sensor->setLife({});
    QVERIFY(!m_sensor->coil(Notification));
}

void SensorStateTest::reservedBitsMayReadAsOnes()
{
    const quint16 before = m_sensor->stateWord(0);
    m_sensor->setReservedBits(true);
    QCOMPARE(m_sensor->stateWord(0), quint16(before | 0xc000));
    QCOMPARE(m_sensor->stateWord(1), quint16(0xfff0));
    QVERIFY(!m_sensor->coil(Notification)); // they mean nothing
    QVERIFY(!m_sensor->coil(0) && !m_sensor->coil(65));
}

void SensorStateTest::everyCoilUsedIsNamedInTheCatalog()
{
    m_sensor->setReservedBits(true);
    for (const Coil& coil : Catalog::hlG2().coils()) {
        if (coil.reserved())
            QVERIFY2(m_sensor->coil(coil.number), qPrintable(QString::number(coil.number)));
    }
    m_sensor->setReservedBits(false);
    for (const Coil& coil : Catalog::hlG2().coils()) {
        if (m_sensor->coil(coil.number))
            QVERIFY2(!coil.reserved(), qPrintable(QString::number(coil.number)));
    }
}

QTEST_GUILESS_MAIN(SensorStateTest)
#include "tst_sensor_state.moc"

// §4.4 Judgment Setting: what is HIGH, GO and LOW, with the numbers of every distance type.
#include "manual_items.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

class ManualJudgmentTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void defaultsJudgeTheMeasurementRange_data();
    void defaultsJudgeTheMeasurementRange();
    void exactlyOneJudgmentIsOnWhileThereIsAValue();
    void comparisonIsFinerThanTheValueThatIsRead();
    void judgmentIsOfTheFinalMeasuredValue();
    void hysteresisDelaysTheWayBackOnly();

    void highNotAboveLowIsRefused();
    void lowNotBelowHighIsRefused();
    void notMoreThanTwiceTheHysteresisIsRefused_data();
    void notMoreThanTwiceTheHysteresisIsRefused();
    void setValuesAreKeptAtTheSettingResolution_data();
    void setValuesAreKeptAtTheSettingResolution();

    void changingTheToleranceLeavesHighAndLow();
    void aToleranceNotAboveTheHysteresisIsRefused();
    void hysteresisMayGoBeyondTheTolerance();

private:
    void expectOnly(int coil);
};

void ManualJudgmentTest::expectOnly(int coil)
{
    m_sensor->catchUp();
    for (const int each : {TimerOffHigh, TimerOffGo, TimerOffLow})
        QCOMPARE(m_sensor->coil(each), each == coil);
}

void ManualJudgmentTest::defaultsJudgeTheMeasurementRange_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("high");
    QTest::addColumn<int>("hysteresis");
    // §4.4.1 to §4.4.3, in 0.1 µm
    QTest::newRow("30 mm") << int(SensorModel::HlG203) << 50'000 << 100;
    QTest::newRow("50 mm") << int(SensorModel::HlG205) << 100'000 << 200;
    QTest::newRow("85 mm") << int(SensorModel::HlG208) << 200'000 << 400;
    QTest::newRow("120 mm") << int(SensorModel::HlG212) << 300'000 << 600;
    QTest::newRow("250 mm") << int(SensorModel::HlG225) << 1'500'000 << 3'000;
}

void ManualJudgmentTest::defaultsJudgeTheMeasurementRange()
{
    QFETCH(int, model);
    QFETCH(int, high);
    QFETCH(int, hysteresis);
    make(SensorModel(model));
    const QList<std::pair<Value, int>> places{{0, TimerOffGo},
                                              {high, TimerOffGo}, // it does not exceed
                                              {high + 1, TimerOffHigh},
                                              {high - hysteresis + 1, TimerOffHigh},
                                              {high - hysteresis, TimerOffGo},
                                              {-high, TimerOffGo},
                                              {-high - 1, TimerOffLow},
                                              {-high + hysteresis - 1, TimerOffLow},
                                              {-high + hysteresis, TimerOffGo}};
    for (const auto& [place, coil] : places) {
        m_sensor->placeWorkpiece(place);
        QCOMPARE(value(), place);
        expectOnly(coil);
    }
}

void ManualJudgmentTest::exactlyOneJudgmentIsOnWhileThereIsAValue()
{
    for (Value place = -60'000; place <= 60'000; place += 1'234) {
        m_sensor->placeWorkpiece(place);
        expectOnly(place > 50'000 ? TimerOffHigh : place < -50'000 ? TimerOffLow : TimerOffGo);
    }
}

void ManualJudgmentTest::comparisonIsFinerThanTheValueThatIsRead()
{
    // 1,001 × 0.9991 = 1,000.0991: reads as 1,000 (§5.2.4), and is above it (§4.4.1).
    QVERIFY(write(ItemId::HighSetValue, 1'000));
    QVERIFY(write(ItemId::LowSetValue, -1'000));
    QVERIFY(write(ItemId::Span, 9'991));
    m_sensor->placeWorkpiece(0);
    expectOnly(TimerOffGo);
    m_sensor->placeWorkpiece(1'001);
    QCOMPARE(value(), 1'000);
    expectOnly(TimerOffHigh);
    m_sensor->placeWorkpiece(0);
    m_sensor->placeWorkpiece(-1'001);
    QCOMPARE(value(), -1'000);
    expectOnly(TimerOffLow);
}

void ManualJudgmentTest::judgmentIsOfTheFinalMeasuredValue()
{
    m_sensor->placeWorkpiece(30'000);
    expectOnly(TimerOffGo);
    QVERIFY(write(ItemId::Span, 20'000));
    m_sensor->placeWorkpiece(30'000);
    expectOnly(TimerOffHigh); // 60,000
    QVERIFY(write(ItemId::Offset, -15'000));
    m_sensor->placeWorkpiece(30'000);
    expectOnly(TimerOffGo); // 45,000
    QVERIFY(write(ItemId::InversionOfMeasuredValue, 1));
    m_sensor->placeWorkpiece(30'000);
    expectOnly(TimerOffLow); // −75,000
}

void ManualJudgmentTest::hysteresisDelaysTheWayBackOnly()
{
    QVERIFY(write(ItemId::Hysteresis, 10'000));
    const QList<std::pair<Value, int>> vibration{
        {49'000, TimerOffGo},   {50'001, TimerOffHigh}, {49'000, TimerOffHigh}, {40'001, TimerOffHigh},
        {50'001, TimerOffHigh}, {40'000, TimerOffGo},   {49'000, TimerOffGo},   {-49'000, TimerOffGo},
        {-50'001, TimerOffLow}, {-40'001, TimerOffLow}, {-50'001, TimerOffLow}, {-40'000, TimerOffGo},
        {-50'001, TimerOffLow}, {50'001, TimerOffHigh}, {-50'001, TimerOffLow}};
    for (const auto& [place, coil] : vibration) {
        m_sensor->placeWorkpiece(place);
        expectOnly(coil);
    }
}

void ManualJudgmentTest::highNotAboveLowIsRefused()
{
    QVERIFY(write(ItemId::Hysteresis, 0));
    for (const Value high : {-50'000, -50'001, -95'000}) {
        QCOMPARE(m_sensor->write({{ItemId::HighSetValue, high}}).refusal, Refusal::Data);
        QCOMPARE(readNow(ItemId::HighSetValue), 50'000);
    }
    QVERIFY(write(ItemId::HighSetValue, -49'999));
}

void ManualJudgmentTest::lowNotBelowHighIsRefused()
{
    QVERIFY(write(ItemId::Hysteresis, 0));
    for (const Value low : {50'000, 50'001, 95'000}) {
        QCOMPARE(m_sensor->write({{ItemId::LowSetValue, low}}).refusal, Refusal::Data);
        QCOMPARE(readNow(ItemId::LowSetValue), -50'000);
    }
    QVERIFY(write(ItemId::LowSetValue, 49'999));
}

void ManualJudgmentTest::notMoreThanTwiceTheHysteresisIsRefused_data()
{
    QTest::addColumn<int>("item");
    QTest::addColumn<int>("refused");
    QTest::addColumn<int>("allowed");
    QTest::newRow("HIGH set value") << int(ItemId::HighSetValue) << -49'800 << -49'799;
    QTest::newRow("LOW set value") << int(ItemId::LowSetValue) << 49'800 << 49'799;
    QTest::newRow("hysteresis") << int(ItemId::Hysteresis) << 50'000 << 49'999;
}

void ManualJudgmentTest::notMoreThanTwiceTheHysteresisIsRefused()
{
    QFETCH(int, item);
    QFETCH(int, refused);
    QFETCH(int, allowed);
    const Value before = readNow(ItemId(item));
    QCOMPARE(m_sensor->write({{ItemId(item), refused}}).refusal, Refusal::Data);
    QCOMPARE(readNow(ItemId(item)), before);
    QVERIFY(write(ItemId(item), allowed));
    QCOMPARE(readNow(ItemId(item)), allowed);
}

void ManualJudgmentTest::setValuesAreKeptAtTheSettingResolution_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("resolution");
    QTest::newRow("30 mm") << int(SensorModel::HlG203) << 1;
    QTest::newRow("50 mm") << int(SensorModel::HlG205) << 10;
    QTest::newRow("85 mm") << int(SensorModel::HlG208) << 10;
    QTest::newRow("120 mm") << int(SensorModel::HlG212) << 10;
    QTest::newRow("250 mm") << int(SensorModel::HlG225) << 100;
}

void ManualJudgmentTest::setValuesAreKeptAtTheSettingResolution()
{
    QFETCH(int, model);
    QFETCH(int, resolution);
    make(SensorModel(model));
    const Value written = 34'567;
    const Value kept = written - written % resolution;
    for (const ItemId id : {ItemId::HighSetValue, ItemId::Hysteresis, ItemId::Tolerance}) {
        QVERIFY(write(ItemId::Hysteresis, 0));
        QVERIFY(write(id, written));
        QCOMPARE(readNow(id), kept);
    }
    QVERIFY(write(ItemId::Hysteresis, 0));
    QVERIFY(write(ItemId::LowSetValue, -written));
    QCOMPARE(readNow(ItemId::LowSetValue), -kept);
}

void ManualJudgmentTest::changingTheToleranceLeavesHighAndLow()
{
    QVERIFY(write(ItemId::Tolerance, 1'000));
    QCOMPARE(readNow(ItemId::HighSetValue), 50'000);
    QCOMPARE(readNow(ItemId::LowSetValue), -50'000);
}

void ManualJudgmentTest::aToleranceNotAboveTheHysteresisIsRefused()
{
    QVERIFY(write(ItemId::Hysteresis, 300));
    for (const Value tolerance : {300, 299, 1}) {
        QCOMPARE(m_sensor->write({{ItemId::Tolerance, tolerance}}).refusal, Refusal::Data);
        QCOMPARE(readNow(ItemId::Tolerance), 20'000);
    }
    QVERIFY(write(ItemId::Tolerance, 301));
}

void ManualJudgmentTest::hysteresisMayGoBeyondTheTolerance()
{
    QVERIFY(write(ItemId::Tolerance, 200));
    QVERIFY(write(ItemId::Hysteresis, 40'000));
    QCOMPARE(readNow(ItemId::Tolerance), 200);
}

QTEST_GUILESS_MAIN(ManualJudgmentTest)
#include "tst_manual_judgment.moc"

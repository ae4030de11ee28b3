// §4.9 at the sensor, with the ranges and resolutions of the distance types; the procedures themselves are in
// tst_procedures, the arithmetic in tst_teaching.
#include "manual_items.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

namespace {

enum ExecutionState { NotExecuted = 0, Executing = 1, Success = 2, Failed = 3 }; // Register 400133

} // namespace

class ManualTeachingTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void theWindowIsAtTheSettingResolution_data();
    void theWindowIsAtTheSettingResolution();
    void onePointStaysInTheSettingRange_data();
    void onePointStaysInTheSettingRange();
    void theToleranceCountsForOnePointOnly();
    void aHysteresisBeyondTheToleranceLetsOnePointFail();
    void beyondTheDisplayRangeItFails();
    void theModeDecidesHowManyPointsAreTaken_data();
    void theModeDecidesHowManyPointsAreTaken();

private:
    int teach(const QList<Value>& places); ///< Answers with the execution state.
};

int ManualTeachingTest::teach(const QList<Value>& places)
{
    static constexpr ItemId points[] = {ItemId::Teaching1stPoint, ItemId::Teaching2ndPoint,
                                        ItemId::Teaching3rdPoint};
    write(ItemId::TeachingMode, Value(places.size()));
    write(ItemId::ExecutionOfTeaching, 1);
    for (qsizetype i = 0; i < places.size(); ++i) {
        m_sensor->placeWorkpiece(places.at(i));
        write(points[i], 0);
    }
    return readNow(ItemId::TeachingExecutionState);
}

void ManualTeachingTest::theWindowIsAtTheSettingResolution_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("high");
    QTest::addColumn<int>("low");
    // 2 points at +12,345 and −12,345 × 0.1 µm: what is finer than the resolution becomes 0.
    QTest::newRow("30 mm, 0.1 um") << int(SensorModel::HlG203) << 12'345 << -12'345;
    QTest::newRow("50 mm, 1 um") << int(SensorModel::HlG205) << 12'340 << -12'340;
    QTest::newRow("85 mm, 1 um") << int(SensorModel::HlG208) << 12'340 << -12'340;
    QTest::newRow("120 mm, 1 um") << int(SensorModel::HlG212) << 12'340 << -12'340;
    QTest::newRow("250 mm, 10 um") << int(SensorModel::HlG225) << 12'300 << -12'300;
}

void ManualTeachingTest::theWindowIsAtTheSettingResolution()
{
    QFETCH(int, model);
    QFETCH(int, high);
    QFETCH(int, low);
    make(SensorModel(model));
    QCOMPARE(teach({-12'345, 12'345}), int(Success));
    QCOMPARE(readNow(ItemId::HighSetValue), high);
    QCOMPARE(readNow(ItemId::LowSetValue), low);
}

void ManualTeachingTest::onePointStaysInTheSettingRange_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("limit");
    QTest::newRow("30 mm") << int(SensorModel::HlG203) << 95'000;
    QTest::newRow("50 mm") << int(SensorModel::HlG205) << 950'000;
    QTest::newRow("85 mm") << int(SensorModel::HlG208) << 950'000;
    QTest::newRow("120 mm") << int(SensorModel::HlG212) << 950'000;
    QTest::newRow("250 mm") << int(SensorModel::HlG225) << 9'500'000;
}

void ManualTeachingTest::onePointStaysInTheSettingRange()
{
    QFETCH(int, model);
    QFETCH(int, limit);
    make(SensorModel(model));
    const Value tolerance = limit / 5;
    QVERIFY(write(ItemId::Tolerance, tolerance));
    QVERIFY(write(ItemId::Offset, limit - 1'000));
    QCOMPARE(teach({0}), int(Success));
    QCOMPARE(readNow(ItemId::HighSetValue), limit);
    QCOMPARE(readNow(ItemId::LowSetValue), limit - 1'000 - tolerance);
    QVERIFY(write(ItemId::Offset, 1'000 - limit));
    QCOMPARE(teach({0}), int(Success));
    QCOMPARE(readNow(ItemId::HighSetValue), 1'000 - limit + tolerance);
    QCOMPARE(readNow(ItemId::LowSetValue), -limit);
}

void ManualTeachingTest::theToleranceCountsForOnePointOnly()
{
    for (const Value tolerance : {200, 90'000}) {
        QVERIFY(write(ItemId::Tolerance, tolerance));
        QCOMPARE(teach({3'000, -1'000}), int(Success));
        QCOMPARE(readNow(ItemId::HighSetValue), 3'000);
        QCOMPARE(readNow(ItemId::LowSetValue), -1'000);
        QCOMPARE(teach({3'000, -1'000, 2'000}), int(Success));
        QCOMPARE(readNow(ItemId::HighSetValue), 2'500);
        QCOMPARE(readNow(ItemId::LowSetValue), 500);
    }
}

void ManualTeachingTest::aHysteresisBeyondTheToleranceLetsOnePointFail()
{
    QVERIFY(write(ItemId::Tolerance, 2'000));
    QVERIFY(write(ItemId::Hysteresis, 2'000)); // §4.4.5: whatever the tolerance
    QCOMPARE(teach({0}), int(Failed));         // not more than twice the hysteresis
    QCOMPARE(readNow(ItemId::HighSetValue), 50'000);
    QCOMPARE(readNow(ItemId::LowSetValue), -50'000);
    QVERIFY(write(ItemId::Hysteresis, 1'999));
    QCOMPARE(teach({0}), int(Success));
    QCOMPARE(readNow(ItemId::HighSetValue), 2'000);
}

void ManualTeachingTest::beyondTheDisplayRangeItFails()
{
    for (const Value sign : {1, -1}) {
        QVERIFY(write(ItemId::Offset, sign * 95'000));
        m_sensor->placeWorkpiece(sign);
        QCOMPARE(value(), sign * 9'600'000); // +OVER and -OVER
        QCOMPARE(teach({sign}), int(Failed));
        QCOMPARE(teach({0, sign}), int(Failed));
        QCOMPARE(readNow(ItemId::HighSetValue), 50'000);
        QCOMPARE(readNow(ItemId::LowSetValue), -50'000);
    }
}

void ManualTeachingTest::theModeDecidesHowManyPointsAreTaken_data()
{
    QTest::addColumn<int>("mode");
    for (int mode = 1; mode <= 3; ++mode)
        QTest::addRow("%d points", mode) << mode;
}

void ManualTeachingTest::theModeDecidesHowManyPointsAreTaken()
{
    QFETCH(int, mode);
    QVERIFY(write(ItemId::TeachingMode, mode));
    QCOMPARE(readNow(ItemId::TeachingExecutionState), int(NotExecuted));
    QVERIFY(write(ItemId::ExecutionOfTeaching, 1));
    int taken = 0;
    for (const ItemId point :
         {ItemId::Teaching1stPoint, ItemId::Teaching2ndPoint, ItemId::Teaching3rdPoint}) {
        if (readNow(ItemId::TeachingExecutionState) != Executing)
            break;
        m_sensor->placeWorkpiece(++taken * 1'000);
        QVERIFY(write(point, 0));
    }
    QCOMPARE(taken, mode);
    QCOMPARE(readNow(ItemId::TeachingExecutionState), int(Success));
}

QTEST_GUILESS_MAIN(ManualTeachingTest)
#include "tst_manual_teaching.moc"

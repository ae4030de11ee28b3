// §4.3.1, §4.3.2, §4.3.5 to §4.3.7: from samples to the final measured value.
#include "manual_items.h"

using namespace lds::emulator;
using namespace lds::catalog;
using namespace lds::test;

class ManualSensingTest : public SensorFixture {
    Q_OBJECT

private Q_SLOTS:
    void init() { setUp(); }

    void cycleTimesCountIsHowLongTheAverageTakes_data();
    void cycleTimesCountIsHowLongTheAverageTakes();
    void aChangedCountIsIndeterminateUntilFullAgain_data();
    void aChangedCountIsIndeterminateUntilFullAgain();

    void inversionTurnsTheSignAndNothingElse();
    void inversionLeavesSetValuesAndZeroCorrection();
    void spanMultipliesAfterZeroAndOffsetIsAdded_data();
    void spanMultipliesAfterZeroAndOffsetIsAdded();
    void spanGoesInStepsOfATenThousandth();
    void offsetShiftsTheValueByItsSign();
    void offsetIsKeptAtTheSettingResolution_data();
    void offsetIsKeptAtTheSettingResolution();
};

namespace {

// §4.3.1, §4.3.2: what the codes of registers 400113 and 400114 stand for.
constexpr int cyclesUs[] = {100, 200, 500, 1'000, 2'000};
constexpr int counts[] = {1, 4, 16, 64, 256, 512, 1'024};

} // namespace

void ManualSensingTest::cycleTimesCountIsHowLongTheAverageTakes_data()
{
    QTest::addColumn<int>("cycle");
    QTest::addColumn<int>("count");
    for (int cycle = 0; cycle < int(std::size(cyclesUs)); ++cycle) {
        for (int count = 0; count < int(std::size(counts)); ++count)
            QTest::addRow("%d us, %d times", cyclesUs[cycle], counts[count]) << cycle << count;
    }
}

void ManualSensingTest::cycleTimesCountIsHowLongTheAverageTakes()
{
    QFETCH(int, cycle);
    QFETCH(int, count);
    QVERIFY(write(ItemId::SamplingFrequency, cycle));
    QVERIFY(write(ItemId::AverageTimes, count));
    m_sensor->placeWorkpiece(300);
    QVERIFY(write(ItemId::MeasuredValueResetting, 0));
    const int fullUs = cyclesUs[cycle] * counts[count];
    const int shortOfItMs = (fullUs - 2 * cyclesUs[cycle]) / 1'000;
    if (shortOfItMs > 0) {
        m_clock->advanceMs(shortOfItMs);
        QCOMPARE(value(), -9'999'999);
    }
    m_clock->advanceMs(std::max(0, fullUs / 1'000 - shortOfItMs) + 1);
    QCOMPARE(value(), 300);
}

void ManualSensingTest::aChangedCountIsIndeterminateUntilFullAgain_data()
{
    QTest::addColumn<int>("count");
    for (int count = 0; count < int(std::size(counts)); ++count)
        QTest::addRow("%d times", counts[count]) << count;
}

void ManualSensingTest::aChangedCountIsIndeterminateUntilFullAgain()
{
    QFETCH(int, count);
    const Value other = count == 6 ? 5 : 6;
    QVERIFY(write(ItemId::AverageTimes, other));
    m_sensor->placeWorkpiece(300);
    QCOMPARE(value(), 300);
    QVERIFY(write(ItemId::AverageTimes, count));
    if (count > 0) { // one sample fills an average of one
        QVERIFY(m_sensor->coil(Indeterminate));
        QCOMPARE(m_sensor->read(ItemId::MeasuredValue), -9'999'999);
        for (const int coil : {High, Go, Low, TimerOffHigh, TimerOffGo, TimerOffLow})
            QVERIFY(!m_sensor->coil(coil));
    }
    m_sensor->placeWorkpiece(300);
    QCOMPARE(value(), 300);
    QVERIFY(!m_sensor->coil(Indeterminate));
}

void ManualSensingTest::inversionTurnsTheSignAndNothingElse()
{
    QCOMPARE(readNow(ItemId::InversionOfMeasuredValue), 0);
    for (const Value place : {1, -1, 12'345, -49'999}) {
        QVERIFY(write(ItemId::InversionOfMeasuredValue, 0));
        m_sensor->placeWorkpiece(place);
        QCOMPARE(value(), place);
        QVERIFY(write(ItemId::InversionOfMeasuredValue, 1));
        m_sensor->placeWorkpiece(place);
        QCOMPARE(value(), -place);
    }
}

void ManualSensingTest::inversionLeavesSetValuesAndZeroCorrection()
{
    QVERIFY(write(ItemId::HighSetValue, 40'000));
    QVERIFY(write(ItemId::LowSetValue, -30'000));
    m_sensor->placeWorkpiece(500);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QCOMPARE(value(), 0);
    const Nanometres correction = m_sensor->memory().zeroCorrection(0);
    QVERIFY(write(ItemId::InversionOfMeasuredValue, 1));
    QCOMPARE(readNow(ItemId::HighSetValue), 40'000);
    QCOMPARE(readNow(ItemId::LowSetValue), -30'000);
    QCOMPARE(m_sensor->memory().zeroCorrection(0), correction);
    m_sensor->placeWorkpiece(500);
    QCOMPARE(value(), -1'000); // no longer 0 (§4.10)
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QCOMPARE(value(), 0); // adjusted again
}

void ManualSensingTest::spanMultipliesAfterZeroAndOffsetIsAdded_data()
{
    QTest::addColumn<int>("span");
    QTest::addColumn<int>("offset");
    QTest::addColumn<int>("final"); ///< Of 20,000 where 8,000 is zero.
    QTest::newRow("as delivered") << 10'000 << 0 << 12'000;
    QTest::newRow("twice") << 20'000 << 0 << 24'000;
    QTest::newRow("a tenth") << 1'000 << 0 << 1'200;
    QTest::newRow("offset alone") << 10'000 << -500 << 11'500;
    QTest::newRow("offset is not multiplied") << 30'000 << 500 << 36'500;
    QTest::newRow("half and back") << 5'000 << -6'000 << 0;
}

void ManualSensingTest::spanMultipliesAfterZeroAndOffsetIsAdded()
{
    QFETCH(int, span);
    QFETCH(int, offset);
    QFETCH(int, final);
    m_sensor->placeWorkpiece(8'000);
    QVERIFY(write(ItemId::ZeroSetting, 1));
    QVERIFY(write(ItemId::Span, span));
    QVERIFY(write(ItemId::Offset, offset));
    m_sensor->placeWorkpiece(20'000);
    QCOMPARE(value(), final);
}

void ManualSensingTest::spanGoesInStepsOfATenThousandth()
{
    QVERIFY(write(ItemId::Span, 10'001));
    m_sensor->placeWorkpiece(40'000);
    QCOMPARE(value(), 40'004);
    QVERIFY(write(ItemId::Span, 9'999));
    m_sensor->placeWorkpiece(40'000);
    QCOMPARE(value(), 39'996);
}

void ManualSensingTest::offsetShiftsTheValueByItsSign()
{
    m_sensor->placeWorkpiece(100);
    QVERIFY(write(ItemId::Offset, 50));
    m_sensor->placeWorkpiece(100);
    QCOMPARE(value(), 150);
    QVERIFY(write(ItemId::Offset, -250));
    m_sensor->placeWorkpiece(100);
    QCOMPARE(value(), -150);
}

void ManualSensingTest::offsetIsKeptAtTheSettingResolution_data()
{
    QTest::addColumn<int>("model");
    QTest::addColumn<int>("stored"); ///< Of 12,345 × 0.1 µm.
    QTest::newRow("30 mm, 0.1 um") << int(SensorModel::HlG203) << 12'345;
    QTest::newRow("50 mm, 1 um") << int(SensorModel::HlG205) << 12'340;
    QTest::newRow("85 mm, 1 um") << int(SensorModel::HlG208) << 12'340;
    QTest::newRow("120 mm, 1 um") << int(SensorModel::HlG212) << 12'340;
    QTest::newRow("250 mm, 10 um") << int(SensorModel::HlG225) << 12'300;
}

void ManualSensingTest::offsetIsKeptAtTheSettingResolution()
{
    QFETCH(int, model);
    QFETCH(int, stored);
    make(SensorModel(model));
    QVERIFY(write(ItemId::Offset, 12'345));
    QCOMPARE(readNow(ItemId::Offset), stored);
    QVERIFY(write(ItemId::Offset, -12'345));
    QCOMPARE(readNow(ItemId::Offset), -stored);
}

QTEST_GUILESS_MAIN(ManualSensingTest)
#include "tst_manual_sensing.moc"

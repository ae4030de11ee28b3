#include "manual_scheduler.h"
#include "trend_value_scale.h"

#include <QtTest>

using namespace lds::ui;
using Range = TrendValueScale::Range;

class TrendValueScaleTest : public QObject {
    Q_OBJECT

private:
    lds::ports::ManualScheduler m_clock;

    void fit(TrendValueScale& scale, double low, double high,
             const TrendValueScale::Limits& limits = {}) const
    {
        scale.fit(Range{low, high}, limits, m_clock.nowNs());
    }

private Q_SLOTS:
    void fittingLeavesRoomAroundTheData()
    {
        TrendValueScale scale;
        fit(scale, 10'000, 20'000);
        QVERIFY(scale.range().low < 10'000 && scale.range().low > 5'000);
        QVERIFY(scale.range().high > 20'000 && scale.range().high < 25'000);
    }

    void widensAtOnce()
    {
        TrendValueScale scale;
        fit(scale, 10'000, 20'000);
        fit(scale, 10'000, 60'000);
        QVERIFY(scale.range().high > 60'000);
        QVERIFY(!scale.narrowsAtNs());
    }

    void narrowsOnlyAfterTwoSeconds()
    {
        TrendValueScale scale;
        fit(scale, 10'000, 60'000);
        const Range wide = scale.range();
        fit(scale, 10'000, 20'000);
        QCOMPARE(scale.range(), wide);
        QCOMPARE(scale.narrowsAtNs(), std::optional(m_clock.nowNs() + 2'000'000'000));
        m_clock.advanceMs(1999);
        fit(scale, 10'000, 20'000);
        QCOMPARE(scale.range(), wide);
        m_clock.advanceMs(1);
        fit(scale, 10'000, 20'000);
        QVERIFY(scale.range().high < 25'000);
        QVERIFY(!scale.narrowsAtNs());
    }

    void aPeakWithinTheTwoSecondsKeepsTheAxis()
    {
        TrendValueScale scale;
        fit(scale, 10'000, 60'000);
        const Range wide = scale.range();
        fit(scale, 10'000, 20'000);
        m_clock.advanceMs(1500);
        fit(scale, 10'000, 60'000);
        m_clock.advanceMs(1500);
        fit(scale, 10'000, 20'000);
        QCOMPARE(scale.range(), wide);
    }

    void smallChangesDoNotMoveTheAxis()
    {
        TrendValueScale scale;
        fit(scale, 10'000, 20'000);
        const Range before = scale.range();
        for (int i = 0; i < 50; ++i) {
            m_clock.advanceMs(100);
            fit(scale, 10'000 + i % 7 * 20, 20'000 - i % 5 * 20);
            QCOMPARE(scale.range(), before);
        }
    }

    void limitsNearTheDataAreFittedIn()
    {
        TrendValueScale scale;
        fit(scale, 10'000, 15'000, {{17'500, 7'500}});
        QVERIFY(scale.range().low < 7'500);
        QVERIFY(scale.range().high > 17'500);
    }

    void aSteadyValueStandsInItsWindow()
    {
        TrendValueScale scale;
        fit(scale, 12'000, 12'002, {{17'500, 7'500}});
        QVERIFY(scale.range().low < 7'500 && scale.range().high > 17'500);
        scale.setAutomatic();
        fit(scale, 19'000, 19'002, {{17'500, 7'500}}); // just above it
        QVERIFY(scale.range().low < 7'500 && scale.range().high > 19'000);
    }

    void aWindowFarOffIsLeftOut()
    {
        TrendValueScale scale;
        fit(scale, 90'000, 90'100, {{17'500, 7'500}});
        QVERIFY(scale.range().low > 80'000);
    }

    void limitsThatWouldFlattenTheLineAreLeftOut()
    {
        TrendValueScale scale;
        fit(scale, 10'000, 10'200, {{95'000, -95'000}, true});
        QVERIFY(scale.range().high < 11'000);
        QVERIFY(scale.range().low > 9'000);
    }

    void aConstantValueStillHasAnAxis()
    {
        TrendValueScale scale;
        fit(scale, 12'345, 12'345);
        QVERIFY(scale.range().span() >= TrendValueScale::smallestSpan);
        QVERIFY(scale.range().low < 12'345 && scale.range().high > 12'345);
    }

    void withoutAValueTheLimitsAreShownUntilOneComes()
    {
        TrendValueScale scale;
        scale.fit(std::nullopt, {{17'500, 7'500}}, m_clock.nowNs());
        QVERIFY(scale.range().low < 7'500 && scale.range().high > 17'500);
        fit(scale, 100'000, 110'000);
        QVERIFY(scale.range().low > 50'000);
    }

    void aStretchWithoutValuesKeepsTheAxis()
    {
        TrendValueScale scale;
        fit(scale, 10'000, 20'000);
        const Range before = scale.range();
        m_clock.advanceMs(10'000);
        scale.fit(std::nullopt, {{17'500, 7'500}}, m_clock.nowNs());
        QCOMPARE(scale.range(), before);
    }

    void zoomByHandKeepsTheAnchorAndStopsFitting()
    {
        TrendValueScale scale;
        scale.setRange({0, 10'000});
        scale.zoomBy(0.5, 2'000);
        QCOMPARE(scale.range(), (Range{1'000, 6'000}));
        QVERIFY(!scale.isAutomatic());
        fit(scale, -50'000, 50'000);
        QCOMPARE(scale.range(), (Range{1'000, 6'000}));
        scale.setAutomatic();
        fit(scale, -50'000, 50'000);
        QVERIFY(scale.range().high > 50'000);
    }

    void zoomByHandHasItsEnds()
    {
        TrendValueScale scale;
        scale.zoomBy(1e-9, 0);
        QVERIFY(qFuzzyCompare(scale.range().span(), TrendValueScale::smallestSpan));
        scale.zoomBy(1e12, 0);
        QVERIFY(qFuzzyCompare(scale.range().span(), TrendValueScale::largestSpan));
        scale.panBy(1e12);
        QVERIFY(scale.range().low <= TrendValueScale::largestSpan);
    }
};

QTEST_GUILESS_MAIN(TrendValueScaleTest)
#include "tst_trend_value_scale.moc"

#include "trend_time_window.h"

#include <QtTest>

using namespace lds::ui;

namespace {
constexpr qint64 second = 1'000'000'000;
constexpr TrendSpan data{100 * second, 200 * second};
constexpr TrendSpan grown{100 * second, 205 * second};
} // namespace

class TrendTimeWindowTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void followingKeepsTheNewestSampleAtTheRightEdge()
    {
        const TrendTimeWindow window;
        QVERIFY(window.isFollowing());
        QCOMPARE(window.span(data), (TrendSpan{190 * second, 200 * second}));
        QCOMPARE(window.span(grown), (TrendSpan{195 * second, 205 * second}));
    }

    void pauseStandsStillWhateverArrivesAndGoesBackToFollowing()
    {
        TrendTimeWindow window;
        window.setPaused(true, data);
        QCOMPARE(window.span(grown), window.span(data));
        QCOMPARE(window.span(grown), (TrendSpan{190 * second, 200 * second}));
        window.setPaused(false, grown);
        QVERIFY(window.isFollowing());
        QCOMPARE(window.span(grown), (TrendSpan{195 * second, 205 * second}));
    }

    void pauseOfAWindowLookingBackReturnsToLookingBack()
    {
        TrendTimeWindow window;
        window.panBy(-20 * second, data);
        const TrendSpan before = window.span(data);
        window.setPaused(true, data);
        window.setPaused(false, grown);
        QVERIFY(!window.isFollowing());
        QCOMPARE(window.span(grown), before);
    }

    void panningLeavesFollowAndStandsStill()
    {
        TrendTimeWindow window;
        window.panBy(-5 * second, data);
        QVERIFY(!window.isFollowing());
        QCOMPARE(window.span(data), (TrendSpan{185 * second, 195 * second}));
        QCOMPARE(window.span(grown), (TrendSpan{185 * second, 195 * second}));
        window.follow();
        QCOMPARE(window.span(grown), (TrendSpan{195 * second, 205 * second}));
    }

    void panningWhilePausedMovesThePausedView()
    {
        TrendTimeWindow window;
        window.setPaused(true, data);
        window.panBy(-5 * second, grown);
        QVERIFY(window.isPaused());
        QCOMPARE(window.span(grown), (TrendSpan{185 * second, 195 * second}));
        window.setPaused(false, grown);
        QCOMPARE(window.span(grown), (TrendSpan{185 * second, 195 * second}));
    }

    void someDataAlwaysStaysInSight()
    {
        TrendTimeWindow window;
        window.panBy(-1'000'000 * second, data);
        QVERIFY(window.span(data).toNs > data.fromNs);
        QCOMPARE(window.span(data).lengthNs(), 10 * second);
        window.panBy(2'000'000 * second, data);
        QVERIFY(window.span(data).fromNs < data.toNs);
        QCOMPARE(window.span(data).lengthNs(), 10 * second);
    }

    void zoomKeepsTheInstantUnderThePointer()
    {
        TrendTimeWindow window;
        window.panBy(-50 * second, data); // 140 … 150
        window.zoomBy(0.5, 0.2, data);    // around 142
        QCOMPARE(window.span(data), (TrendSpan{141 * second, 146 * second}));
        window.zoomBy(2, 0.2, data);
        QCOMPARE(window.span(data), (TrendSpan{140 * second, 150 * second}));
    }

    void zoomAtTheRightEdgeGoesOnFollowing()
    {
        TrendTimeWindow window;
        window.zoomBy(0.5, 1.0, data);
        QVERIFY(window.isFollowing());
        QCOMPARE(window.span(grown), (TrendSpan{200 * second, 205 * second}));
    }

    void zoomIntoThePastLeavesFollow()
    {
        TrendTimeWindow window;
        window.zoomBy(0.5, 0.0, data);
        QVERIFY(!window.isFollowing());
        QCOMPARE(window.span(grown), (TrendSpan{190 * second, 195 * second}));
    }

    void zoomStopsAtTheShortestAndTheLongest()
    {
        TrendTimeWindow window;
        window.zoomBy(1e-12, 0.5, data);
        QCOMPARE(window.span(data).lengthNs(), TrendTimeWindow::shortestNs);
        window.zoomBy(1e18, 0.5, data);
        QCOMPARE(window.span(data).lengthNs(), TrendTimeWindow::longestNs);
    }

    void allShowsEverythingAndGrows()
    {
        TrendTimeWindow window;
        window.showAll(data);
        QCOMPARE(window.span(data), data);
        QCOMPARE(window.span(grown), grown);
        window.setPaused(true, data);
        QCOMPARE(window.span(grown), data);
        window.setLength(60 * second, grown);
        QVERIFY(!window.showsAll());
        QCOMPARE(window.span(grown), (TrendSpan{140 * second, 200 * second}));
    }

    void allOfASingleSampleStillHasATimeAxis()
    {
        TrendTimeWindow window;
        const TrendSpan one{100 * second, 100 * second};
        window.showAll(one);
        QVERIFY(window.span(one).lengthNs() >= second);
    }

    void aChosenLengthKeepsTheRightEdge()
    {
        TrendTimeWindow window;
        window.panBy(-20 * second, data); // 170 … 180
        window.setLength(60 * second, data);
        QCOMPARE(window.span(grown), (TrendSpan{120 * second, 180 * second}));
    }
};

QTEST_GUILESS_MAIN(TrendTimeWindowTest)
#include "tst_trend_time_window.moc"

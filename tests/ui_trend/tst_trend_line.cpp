#include "trend_line.h"
#include "trend_scene.h"

#include <QtTest>

using namespace lds::ui;
using namespace lds::measurement;

namespace {

constexpr qint64 ms = 1'000'000;

Measurement valueAt(qint64 atMs, Value value, quint16 state = GoBit)
{
    Measurement sample;
    sample.monotonicNs = atMs * ms;
    sample.wallMs = 1'700'000'000'000 + atMs;
    sample.value = value;
    sample.kind = ValueKind::Valid;
    sample.state = state;
    return sample;
}

Measurement noValueAt(qint64 atMs, quint16 state = AlarmBit)
{
    Measurement sample = valueAt(atMs, 9'999'999, state);
    sample.kind = ValueKind::Alarm;
    return sample;
}

/// 1000 pixels for one second, 100 pixels for 0 … 10,000.
PlotScale scaleOf(qint64 fromMs, qint64 toMs) { return {{fromMs * ms, toMs * ms}, {0, 10'000}, 1000, 100}; }

QList<TrendSegment> segments(const TrendStore& store, qint64 fromMs, qint64 toMs)
{
    const PlotScale scale = scaleOf(fromMs, toMs);
    return lineSegments(readColumns(store, scale.span, int(scale.width)), scale);
}

} // namespace

class TrendLineTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aSteadyStreamIsOneSegment()
    {
        TrendStore store;
        for (int t = 0; t <= 1000; t += 10)
            store.append(valueAt(t, t % 20 == 0 ? 1000 : 2000));
        const auto line = segments(store, 0, 1000);
        QCOMPARE(line.size(), 1);
        QVERIFY(!line[0].frozen);
        QVERIFY(line[0].points.first().x() < 1);
        QVERIFY(line[0].points.last().x() > 999);
    }

    void aSampleWithoutValueBreaksTheLine()
    {
        TrendStore store;
        for (int t = 0; t < 1000; t += 10)
            store.append(t >= 400 && t < 500 ? noValueAt(t) : valueAt(t, t));
        const auto line = segments(store, 0, 1000);
        QCOMPARE(line.size(), 2);
        QVERIFY(line[0].points.last().x() < 395);
        QVERIFY(line[1].points.first().x() > 499);
    }

    void aPauseInTheStreamBreaksTheLine()
    {
        TrendStore store;
        for (int t = 0; t < 1000; t += 100)
            store.append(valueAt(t, t));
        for (int t = 3000; t < 4000; t += 100)
            store.append(valueAt(t, t));
        QCOMPARE(segments(store, 0, 4000).size(), 2);
    }

    void aLoneSampleStaysVisible()
    {
        TrendStore store;
        store.append(noValueAt(100));
        store.append(valueAt(500, 5000));
        store.append(noValueAt(900));
        const auto line = segments(store, 0, 1000);
        QCOMPARE(line.size(), 1);
        QCOMPARE(line[0].points.size(), 2);
        QVERIFY(line[0].points.last().x() - line[0].points.first().x() > 1);
    }

    void aColumnKeepsItsSmallestAndLargestValue()
    {
        TrendStore store;
        for (int t = 0; t < 1000; ++t)
            store.append(valueAt(t, t == 501 ? 9'000 : t == 503 ? 500 : 5'000));
        const PlotScale scale{{0, 1000 * ms}, {0, 10'000}, 100, 100}; // ten samples a column
        const auto line = lineSegments(readColumns(store, scale.span, 100), scale);
        QCOMPARE(line.size(), 1);
        double lowest = 100;
        double highest = 0;
        for (const QPointF& point : line[0].points) {
            lowest = std::min(lowest, point.y());
            highest = std::max(highest, point.y());
        }
        QCOMPARE(lowest, 5.0);
        QCOMPARE(highest, 90.0);
    }

    void thereAreAtMostTwoPointsAColumn()
    {
        TrendStore store;
        for (int t = 0; t < 100'000; ++t)
            store.append(valueAt(t, (t * 7919) % 10'000));
        const PlotScale scale{{0, 100'000 * ms}, {0, 10'000}, 1000, 100};
        const TrendColumns columns = readColumns(store, scale.span, 1000);
        qsizetype points = 0;
        for (const auto& segment : lineSegments(columns, scale))
            points += segment.points.size();
        QVERIFY(points > 1500);
        QVERIFY(points <= qsizetype(2 * columns.columns.size()));
    }

    void theLineRunsOnToTheSamplesOutsideTheWindow()
    {
        TrendStore store;
        for (int t = 0; t <= 2000; t += 500)
            store.append(valueAt(t, 5000 + t));
        const auto line = segments(store, 700, 1300); // only the sample at 1000 lies inside
        QCOMPARE(line.size(), 1);
        QVERIFY(line[0].points.first().x() < 0);
        QVERIFY(line[0].points.last().x() > 1000);
        // A window between two samples still shows the line between them.
        const auto between = segments(store, 1100, 1200);
        QCOMPARE(between.size(), 1);
        QVERIFY(between[0].points.first().x() < 0);
        QVERIFY(between[0].points.last().x() > 1000);
    }

    void nothingRunsOnAcrossAGapAtTheEdge()
    {
        TrendStore store;
        store.append(valueAt(0, 1000));
        store.append(noValueAt(600));
        store.append(valueAt(1000, 2000));
        const auto line = segments(store, 700, 1300);
        QCOMPARE(line.size(), 1);
        QVERIFY(line[0].points.first().x() > 0);
    }

    void frozenValuesAreASegmentOfTheirOwnThatStaysJoined()
    {
        TrendStore store;
        for (int t = 0; t < 1000; t += 10)
            store.append(valueAt(t, 5000, t >= 400 && t < 600 ? AlarmBit : GoBit));
        const auto line = segments(store, 0, 1000);
        QCOMPARE(line.size(), 3);
        QVERIFY(!line[0].frozen && line[1].frozen && !line[2].frozen);
        QCOMPARE(line[1].points.first(), line[0].points.last());
        QCOMPARE(line[2].points.first(), line[1].points.last());
    }

    void samplesKeepTheirColumnWhileTheWindowMoves()
    {
        TrendStore store;
        for (int t = 0; t < 20'000; ++t)
            store.append(valueAt(t, (t * 7919) % 10'000));
        const TrendColumns before = readColumns(store, {5000 * ms, 15'000 * ms}, 1000);
        const TrendColumns after = readColumns(store, {5013 * ms, 15'013 * ms}, 1000);
        QCOMPARE(before.columnNs, after.columnNs);
        QCOMPARE(after.fromNs - before.fromNs, before.columnNs); // by whole columns only
        for (std::size_t i = 1; i < 1000; ++i)
            QVERIFY(before.columns[i].maximum == after.columns[i - 1].maximum);
    }

    void statesBecomeRunsThatBridgeTheSpaceBetweenSamples()
    {
        TrendStore store;
        for (int t = 0; t < 1000; t += 50)
            store.append(valueAt(t, 5000, t < 500 ? HighBit : GoBit));
        const PlotScale scale = scaleOf(0, 1000);
        const TrendColumns columns = readColumns(store, scale.span, 1000);
        const auto high = stateRuns(columns, scale, HighBit);
        const auto go = stateRuns(columns, scale, GoBit);
        QCOMPARE(high.size(), 1);
        QCOMPARE(go.size(), 1);
        QCOMPARE(high[0].left, 0.0);
        QCOMPARE(high[0].right, 500.0); // until the sample that says otherwise
        QCOMPARE(go[0].left, 500.0);
        QVERIFY(stateRuns(columns, scale, LowBit).isEmpty());
    }

    void aStateDoesNotOutliveAPauseInTheStream()
    {
        TrendStore store;
        store.append(valueAt(0, 5000, HighBit));
        store.append(valueAt(5000, 5000, HighBit));
        const PlotScale scale = scaleOf(0, 5001);
        QCOMPARE(stateRuns(readColumns(store, scale.span, 1000), scale, HighBit).size(), 2);
    }

    void anAlarmWithoutAValueIsAStateAndAGapButNotFrozen()
    {
        TrendStore store;
        for (int t = 0; t < 1000; t += 10)
            store.append(t >= 400 && t < 500 ? noValueAt(t) : valueAt(t, t));
        const PlotScale scale = scaleOf(0, 1000);
        const TrendColumns columns = readColumns(store, scale.span, 1000);
        QCOMPARE(stateRuns(columns, scale, AlarmBit).size(), 1);
        QVERIFY(frozenRuns(columns, scale).isEmpty());
    }

    void aValueBesideAnAlarmWithoutOneIsNotFrozen()
    {
        TrendStore store;
        for (int t = 0; t < 1000; t += 10)
            store.append(t % 20 == 0 ? noValueAt(t) : valueAt(t, 5000));
        const PlotScale scale{{0, 1000 * ms}, {0, 10'000}, 10, 100}; // both kinds in every column
        const TrendColumns columns = readColumns(store, scale.span, 10);
        QVERIFY(frozenRuns(columns, scale).isEmpty());
        for (const TrendSegment& segment : lineSegments(columns, scale))
            QVERIFY(!segment.frozen);
    }

    void theReadoutTellsTimeExtremesAndState()
    {
        TrendScene scene;
        scene.hasData = true;
        TrendStore store;
        for (int t = 0; t < 10'000; ++t)
            store.append(valueAt(t, t < 5000 ? 12'000 + t % 10 * 10 : 20'000,
                                 quint16(t < 5000 ? GoBit : HighBit | AlarmBit)));
        scene.scale = {{0, 10'000 * ms}, {0, 30'000}, 1000, 100};
        scene.columns = readColumns(store, scene.scale.span, 1000);
        scene.wallOffsetNs = QDateTime(QDate(2026, 3, 1), QTime(10, 21)).toMSecsSinceEpoch() * ms;
        const auto go = readoutAt(scene, 100);
        QVERIFY(go);
        QCOMPARE(go->time, QStringLiteral("10:21:01.005"));
        QCOMPARE(go->value, QStringLiteral("+1.2000 … +1.2090 mm"));
        QCOMPARE(go->state, QStringLiteral("GO"));
        const auto frozen = readoutAt(scene, 800);
        QCOMPARE(frozen->value, QStringLiteral("+2.0000 mm"));
        QCOMPARE(frozen->state, QStringLiteral("HI, alarm, value frozen"));
        scene.hasData = false;
        QVERIFY(!readoutAt(scene, 100));
    }

    void theReadoutMeansTheNearestSample()
    {
        TrendScene scene;
        scene.hasData = true;
        TrendStore store;
        for (int t = 0; t <= 1000; t += 100)
            store.append(valueAt(t, t * 10));
        scene.scale = scaleOf(0, 1000);
        scene.columns = readColumns(store, scene.scale.span, 1000);
        QCOMPARE(readoutAt(scene, 305)->value, QStringLiteral("+0.3000 mm"));
        QCOMPARE(readoutAt(scene, 350)->value, QStringLiteral("not measured"));
    }
};

QTEST_GUILESS_MAIN(TrendLineTest)
#include "tst_trend_line.moc"

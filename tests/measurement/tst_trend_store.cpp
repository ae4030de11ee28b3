#include "trend_store.h"

#include <QtTest>

using namespace lds::measurement;

namespace {

constexpr qint64 ms = 1'000'000;
constexpr qint64 second = 1000 * ms;

Measurement sample(qint64 timeNs, Value value, ValueKind kind = ValueKind::Valid, quint16 state = GoBit)
{
    Measurement measurement;
    measurement.monotonicNs = timeNs;
    measurement.wallMs = 1'700'000'000'000 + timeNs / ms;
    measurement.value = value;
    measurement.kind = kind;
    measurement.state = state;
    measurement.intensity = 552;
    return measurement;
}

TrendStore filled(std::initializer_list<Measurement> samples, qint64 longestJoinNs = second)
{
    TrendStore store(longestJoinNs);
    for (const Measurement& each : samples)
        store.append(each);
    return store;
}

} // namespace

class TrendStoreTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anEmptyStoreHasNothingToShow();
    void aSampleComesBackAsItWas_data();
    void aSampleComesBackAsItWas();
    void detailsAreKeptAsBitsOfTheStateOnly();
    void timeNeverGoesBack();
    void wallTimeFollowsAClockThatIsSet();
    void wallTimeThatJumpsAllTheTimeCostsLittle();
    void lowerBoundFindsTheFirstSampleAtOrAfter();
    void columnsSplitTheWindowEvenly();
    void theEndOfTheWindowIsNotInIt();
    void oneColumnTakesItAll();
    void aWindowThatIsNoneHasNoColumns();
    void windowsBesideTheDataAreEmpty();
    void theLargestWindowThereIsDoesNotOverflow();
    void aSampleWithoutAValueIsAGap();
    void aPauseInTheStreamIsAGap();
    void emptyColumnsBetweenNeighboursAreNoGap();
    void theFirstColumnWithAValueHasNothingToJoin();
    void aFrozenValueIsAValueThatTheStateMarks();
    void samplesWithoutAValueLendTheirStateOnly();
    void rangeIsOverValidValuesOnly();
    void clearForgetsAndGivesMemoryBack();
    void memoryStaysUnderTwentyBytesASample_data();
    void memoryStaysUnderTwentyBytesASample();
};

void TrendStoreTest::anEmptyStoreHasNothingToShow()
{
    const TrendStore store;
    QVERIFY(store.isEmpty());
    QCOMPARE(store.firstNs(), 0);
    QCOMPARE(store.lastNs(), 0);
    QCOMPARE(store.lowerBound(0), std::size_t(0));
    QVERIFY(!store.range(0, second));
    const std::vector<TrendColumn> columns = store.columns(0, second, 3);
    QCOMPARE(columns.size(), std::size_t(3));
    for (const TrendColumn& column : columns)
        QCOMPARE(column, TrendColumn());
}

void TrendStoreTest::aSampleComesBackAsItWas_data()
{
    QTest::addColumn<int>("value");
    QTest::addColumn<ValueKind>("kind");
    QTest::addColumn<quint16>("state");
    QTest::addColumn<quint16>("intensity");
    QTest::newRow("value") << -12'345 << ValueKind::Valid << quint16(GoBit | LaserBit) << quint16(1023);
    QTest::newRow("dark") << 0 << ValueKind::Valid << quint16(0) << quint16(0);
    QTest::newRow("over") << 9'600'000 << ValueKind::Over << quint16(HighBit) << quint16(7);
    QTest::newRow("under") << -9'600'000 << ValueKind::Under << quint16(LowBit) << quint16(7);
    QTest::newRow("indeterminate") << -9'999'999 << ValueKind::Indeterminate << quint16(IndeterminateBit)
                                   << quint16(65'535);
    QTest::newRow("alarm, every state bit")
        << 9'999'999 << ValueKind::Alarm << quint16(0x3fff) << quint16(16'382);
    QTest::newRow("largest number") << std::numeric_limits<int>::max() << ValueKind::Valid << quint16(0)
                                    << quint16(1);
    QTest::newRow("smallest number") << std::numeric_limits<int>::min() << ValueKind::Valid << quint16(0)
                                     << quint16(1);
}

void TrendStoreTest::aSampleComesBackAsItWas()
{
    QFETCH(int, value);
    QFETCH(ValueKind, kind);
    QFETCH(quint16, state);
    QFETCH(quint16, intensity);
    TrendStore store;
    store.append(sample(1 * second, 1));
    Measurement put = sample(123'456'789'012'345, value, kind, state); // after a pause as well
    put.intensity = intensity;
    store.append(put);
    const Measurement got = store.at(1);
    QCOMPARE(got.monotonicNs, put.monotonicNs);
    QCOMPARE(got.wallMs, put.wallMs);
    QCOMPARE(got.value, value);
    QCOMPARE(got.kind, kind);
    QCOMPARE(got.state, state);
    QCOMPARE(got.intensity, intensity);
    QCOMPARE(store.at(0).value, 1);
}

void TrendStoreTest::detailsAreKeptAsBitsOfTheStateOnly()
{
    Measurement put = sample(second, 5, ValueKind::Valid, NotificationBit | ErrorBit | ReservedStateBits);
    put.notification = 3;
    put.error = 1;
    put.errorCode = 0x0200;
    put.intensity = 20'000; // more than the sensor can say
    const TrendStore store = filled({put});
    const Measurement got = store.at(0);
    QCOMPARE(got.state, quint16(NotificationBit | ErrorBit));
    QCOMPARE(got.notification, quint16(0));
    QCOMPARE(got.error, quint16(0));
    QCOMPARE(got.errorCode, quint16(0));
    QCOMPARE(got.intensity, quint16(65'535));
}

void TrendStoreTest::timeNeverGoesBack()
{
    const TrendStore store = filled({sample(5 * second, 1), sample(4 * second, 2), sample(6 * second, 3)});
    QCOMPARE(store.at(1).monotonicNs, 5 * second);
    QCOMPARE(store.at(2).monotonicNs, 6 * second);
    QCOMPARE(store.lowerBound(5 * second), std::size_t(0));
    QCOMPARE(store.columns(5 * second, 7 * second, 2)[0].samples, 2U);
}

void TrendStoreTest::wallTimeFollowsAClockThatIsSet()
{
    TrendStore store;
    for (int i = 0; i < 1'000; ++i) {
        Measurement each = sample(i * 10 * ms + 700'000, i); // between two milliseconds
        if (i >= 500)
            each.wallMs += 3'600'000;
        store.append(each);
    }
    for (const int i : {0, 1, 499, 500, 999}) {
        const qint64 expected = sample(i * 10 * ms + 700'000, i).wallMs + (i >= 500 ? 3'600'000 : 0);
        QVERIFY(qAbs(store.at(std::size_t(i)).wallMs - expected) <= 1);
    }
}

void TrendStoreTest::wallTimeThatJumpsAllTheTimeCostsLittle()
{
    TrendStore store;
    for (int i = 0; i < 100'000; ++i) {
        Measurement each = sample(i * ms, i);
        each.wallMs += i % 2 ? 5'000 : 0;
        store.append(each);
    }
    QVERIFY(store.bytes() <= 20U * 100'000U);
}

void TrendStoreTest::lowerBoundFindsTheFirstSampleAtOrAfter()
{
    const TrendStore store = filled({sample(10, 0), sample(20, 0), sample(20, 0), sample(30, 0)});
    QCOMPARE(store.lowerBound(std::numeric_limits<qint64>::min()), std::size_t(0));
    QCOMPARE(store.lowerBound(10), std::size_t(0));
    QCOMPARE(store.lowerBound(11), std::size_t(1));
    QCOMPARE(store.lowerBound(20), std::size_t(1));
    QCOMPARE(store.lowerBound(21), std::size_t(3));
    QCOMPARE(store.lowerBound(30), std::size_t(3));
    QCOMPARE(store.lowerBound(31), std::size_t(4));
}

void TrendStoreTest::columnsSplitTheWindowEvenly()
{
    const TrendStore store =
        filled({sample(0, 10), sample(1, -20), sample(2, 30), sample(3, 5), sample(4, 7), sample(9, 8)});
    const std::vector<TrendColumn> columns = store.columns(0, 10, 3); // [0,3) [3,6) [6,10)
    QCOMPARE(columns[0], (TrendColumn{true, -20, 30, 10, 30, true, GoBit, 3}));
    QCOMPARE(columns[1], (TrendColumn{true, 5, 7, 5, 7, false, GoBit, 2}));
    QCOMPARE(columns[2], (TrendColumn{true, 8, 8, 8, 8, false, GoBit, 1}));
}

void TrendStoreTest::theEndOfTheWindowIsNotInIt()
{
    const TrendStore store = filled({sample(9, 1), sample(10, 2), sample(19, 3), sample(20, 4)});
    const std::vector<TrendColumn> columns = store.columns(10, 20, 1);
    QCOMPARE(columns[0].samples, 2U);
    QCOMPARE(columns[0].first, 2);
    QCOMPARE(columns[0].last, 3);
    QCOMPARE(store.range(10, 20), (TrendStore::Range{2, 3}));
}

void TrendStoreTest::oneColumnTakesItAll()
{
    TrendStore store;
    for (int i = 0; i < 5'000; ++i)
        store.append(sample(i * ms, i % 100));
    const TrendColumn all = store.columns(0, 5'000 * ms, 1)[0];
    QCOMPARE(all, (TrendColumn{true, 0, 99, 0, 99, true, GoBit, 5'000}));
}

void TrendStoreTest::aWindowThatIsNoneHasNoColumns()
{
    const TrendStore store = filled({sample(5, 1)});
    QVERIFY(store.columns(0, 10, 0).empty());
    QVERIFY(store.columns(0, 10, -1).empty());
    QVERIFY(store.columns(5, 5, 3).empty());
    QVERIFY(store.columns(6, 5, 3).empty());
    QVERIFY(!store.range(5, 5));
    QVERIFY(!store.range(6, 5));
}

void TrendStoreTest::windowsBesideTheDataAreEmpty()
{
    const TrendStore store = filled({sample(100, 1), sample(200, 2)});
    for (const TrendColumn& column : store.columns(-1'000, 100, 4))
        QCOMPARE(column, TrendColumn());
    for (const TrendColumn& column : store.columns(201, 1'000, 4))
        QCOMPARE(column, TrendColumn());
    const TrendColumn inside = store.columns(101, 200, 1)[0];
    QCOMPARE(inside, TrendColumn());
}

void TrendStoreTest::theLargestWindowThereIsDoesNotOverflow()
{
    constexpr qint64 least = std::numeric_limits<qint64>::min();
    constexpr qint64 most = std::numeric_limits<qint64>::max();
    const TrendStore store = filled({sample(-5, 1), sample(5, 2)});
    const std::vector<TrendColumn> columns = store.columns(least, most, 1'200);
    quint32 samples = 0;
    for (const TrendColumn& column : columns)
        samples += column.samples;
    QCOMPARE(samples, 2U);
    QCOMPARE(store.columns(least, most, 2)[0].samples, 1U);
    QCOMPARE(store.range(least, most), (TrendStore::Range{1, 2}));
    // More columns than nanoseconds.
    QCOMPARE(store.columns(4, 7, 1'000)[500].samples, 0U);
    QCOMPARE(store.columns(4, 7, 3)[1].samples, 1U);
}

void TrendStoreTest::aSampleWithoutAValueIsAGap()
{
    const TrendStore store =
        filled({sample(0, 1), sample(1, 2), sample(10, -9'999'999, ValueKind::Indeterminate), sample(11, 3),
                sample(20, 4)});
    const std::vector<TrendColumn> columns = store.columns(0, 30, 3);
    QVERIFY(columns[1].gapBefore);
    QVERIFY2(!columns[2].gapBefore, "the gap lies before the middle column's value");
    QCOMPARE(columns[1].minimum, 3);
    QCOMPARE(columns[1].samples, 2U);
}

void TrendStoreTest::aPauseInTheStreamIsAGap()
{
    const TrendStore store = filled({sample(0, 1), sample(second, 2), sample(2 * second + 1, 3)});
    const std::vector<TrendColumn> columns = store.columns(0, 3 * second, 3);
    QVERIFY2(!columns[1].gapBefore, "exactly the longest distance that is joined");
    QVERIFY(columns[2].gapBefore);
}

void TrendStoreTest::emptyColumnsBetweenNeighboursAreNoGap()
{
    const TrendStore store = filled({sample(0, 1), sample(900 * ms, 2)});
    const std::vector<TrendColumn> columns = store.columns(0, second, 10);
    QVERIFY(!columns[5].hasValue && !columns[5].gapBefore);
    QVERIFY(columns[9].hasValue && !columns[9].gapBefore);
}

void TrendStoreTest::theFirstColumnWithAValueHasNothingToJoin()
{
    const TrendStore store = filled({sample(0, 1), sample(10, 2), sample(20, 3)});
    const std::vector<TrendColumn> columns = store.columns(5, 25, 2);
    QVERIFY(columns[0].gapBefore);
    QVERIFY(!columns[1].gapBefore);
}

/// §4.7.2
void TrendStoreTest::aFrozenValueIsAValueThatTheStateMarks()
{
    const TrendStore store = filled({sample(0, 1), sample(1, 7, ValueKind::Valid, AlarmBit), sample(2, 3)});
    const TrendColumn column = store.columns(0, 3, 1)[0];
    QCOMPARE(column.maximum, 7);
    QCOMPARE(column.stateOr, quint16(GoBit | AlarmBit));
    QVERIFY(!store.columns(0, 3, 3)[2].gapBefore);
    QVERIFY(store.at(1).isFrozen());
}

void TrendStoreTest::samplesWithoutAValueLendTheirStateOnly()
{
    const TrendStore store = filled({sample(0, 9'999'999, ValueKind::Alarm, AlarmBit)});
    const TrendColumn column = store.columns(0, 1, 1)[0];
    QCOMPARE(column, (TrendColumn{false, 0, 0, 0, 0, false, AlarmBit, 1}));
}

void TrendStoreTest::rangeIsOverValidValuesOnly()
{
    const TrendStore store = filled({sample(0, 9'600'000, ValueKind::Over), sample(1, 4), sample(2, -3),
                                     sample(3, -9'600'000, ValueKind::Under)});
    QCOMPARE(store.range(0, 10), (TrendStore::Range{-3, 4}));
    QVERIFY(!store.range(0, 1));
    QVERIFY(!store.range(3, 10));
}

void TrendStoreTest::clearForgetsAndGivesMemoryBack()
{
    TrendStore store(7);
    const std::size_t before = store.bytes();
    for (int i = 0; i < 100'000; ++i)
        store.append(sample(i, i));
    QVERIFY(store.bytes() > before + 1'000'000);
    store.clear();
    QVERIFY(store.isEmpty());
    QCOMPARE(store.bytes(), before);
    store.append(sample(0, 1));
    store.append(sample(8, 1));
    QVERIFY2(store.columns(0, 9, 2)[1].gapBefore, "the longest join is still 7");
}

void TrendStoreTest::memoryStaysUnderTwentyBytesASample_data()
{
    QTest::addColumn<int>("count");
    for (const int count : {1, 17, 257, 1'000, 4'097, 10'000, 65'537, 1'000'000})
        QTest::addRow("%d samples", count) << count;
}

void TrendStoreTest::memoryStaysUnderTwentyBytesASample()
{
    QFETCH(int, count);
    TrendStore store;
    for (int i = 0; i < count; ++i)
        store.append(sample(i * ms, i));
    constexpr std::size_t fixed = 16 * 1024;
    const std::size_t bytes = store.bytes();
    QVERIFY2(bytes <= 20 * std::size_t(count) + fixed, qPrintable(QString::number(bytes)));
    if (count >= 10'000)
        QVERIFY2(bytes <= 20 * std::size_t(count), qPrintable(QString::number(bytes)));
    QVERIFY2(bytes >= 16 * std::size_t(count), "what is stored cannot be less than this");
}

QTEST_APPLESS_MAIN(TrendStoreTest)
#include "tst_trend_store.moc"

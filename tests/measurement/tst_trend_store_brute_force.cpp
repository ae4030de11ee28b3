#include "trend_store.h"

#include <QtTest>

#include <random>

using namespace lds::measurement;

namespace {

constexpr qint64 longestJoin = 1'000;
constexpr int seeds = 60;

/// The definition of trend_store.h, sample by sample.
class BruteForce {
public:
    void append(const Measurement& sample) { m_samples.push_back(sample); }

    std::vector<TrendColumn> columns(qint64 from, qint64 to, int count) const
    {
        std::vector<TrendColumn> columns(static_cast<std::size_t>(count));
        bool seenValue = false;
        bool gap = true; // since the last value of an earlier column
        for (std::size_t i = 0; i < m_samples.size(); ++i) {
            const Measurement& sample = m_samples[i];
            if (sample.monotonicNs < from || sample.monotonicNs >= to)
                continue;
            const std::size_t index = columnOf(sample.monotonicNs, from, to, count);
            TrendColumn& column = columns[index];
            ++column.samples;
            column.stateOr |= sample.state;
            if (i > 0 && sample.monotonicNs - m_samples[i - 1].monotonicNs > longestJoin)
                gap = true;
            if (sample.kind != ValueKind::Valid) {
                gap = true;
                continue;
            }
            if (!column.hasValue) {
                column = {true,         sample.value,      sample.value,   sample.value,
                          sample.value, gap || !seenValue, column.stateOr, column.samples};
            }
            column.minimum = std::min(column.minimum, sample.value);
            column.maximum = std::max(column.maximum, sample.value);
            column.last = sample.value;
            column.hasFrozen = column.hasFrozen || sample.isFrozen();
            seenValue = true;
            gap = false; // counts from this value on: it may be the column's last
        }
        return columns;
    }

    std::optional<TrendStore::Range> range(qint64 from, qint64 to) const
    {
        std::optional<TrendStore::Range> range;
        for (const Measurement& sample : m_samples) {
            if (sample.monotonicNs < from || sample.monotonicNs >= to || sample.kind != ValueKind::Valid)
                continue;
            if (!range)
                range = TrendStore::Range{sample.value, sample.value};
            range->minimum = std::min(range->minimum, sample.value);
            range->maximum = std::max(range->maximum, sample.value);
        }
        return range;
    }

private:
    /// Column k begins at from + ⌊span · k / count⌋; found by trying.
    static std::size_t columnOf(qint64 time, qint64 from, qint64 to, int count)
    {
        std::size_t column = 0;
        while (int(column) + 1 < count && from + (to - from) * qint64(column + 1) / count <= time)
            ++column;
        return column;
    }

    std::vector<Measurement> m_samples;
};

Measurement randomSample(std::mt19937& random, qint64 time)
{
    Measurement sample;
    sample.monotonicNs = time;
    sample.wallMs = time;
    sample.value = Value(random() % 2'000'001) - 1'000'000;
    sample.kind = ValueKind::Valid;
    // Runs of samples without a value, so that whole nodes have none.
    const bool darkStretch = (time / 4'000) % 5 == 0;
    if (darkStretch || random() % 50 == 0)
        sample.kind = ValueKind(1 + random() % 4);
    sample.state = quint16(1U << (random() % 14));
    if (random() % 20 == 0)
        sample.state |= AlarmBit;
    return sample;
}

QByteArray describe(const TrendColumn& column)
{
    return QStringLiteral("value %1 min %2 max %3 first %4 last %5 gap %6 state %7 samples %8")
        .arg(column.hasValue)
        .arg(column.minimum)
        .arg(column.maximum)
        .arg(column.first)
        .arg(column.last)
        .arg(column.gapBefore)
        .arg(column.stateOr)
        .arg(column.samples)
        .toUtf8();
}

} // namespace

class TrendStoreBruteForceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void columnsAndRangesAreWhatEverySampleSays();
    void growingStoresAnswerTheSameAtEveryLength();

private:
    void compare(const TrendStore& store, const BruteForce& truth, qint64 from, qint64 to, int count);
};

void TrendStoreBruteForceTest::compare(const TrendStore& store, const BruteForce& truth, qint64 from,
                                       qint64 to, int count)
{
    const std::vector<TrendColumn> got = store.columns(from, to, count);
    const std::vector<TrendColumn> expected = truth.columns(from, to, count);
    QCOMPARE(got.size(), expected.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        if (!(got[i] == expected[i]))
            QFAIL("column " + QByteArray::number(quint64(i)) + " of " + QByteArray::number(count) + " in [" +
                  QByteArray::number(from) + ", " + QByteArray::number(to) + "):\n got      " +
                  describe(got[i]) + "\n expected " + describe(expected[i]));
    }
    QCOMPARE(store.range(from, to), truth.range(from, to));
}

void TrendStoreBruteForceTest::columnsAndRangesAreWhatEverySampleSays()
{
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937 random{quint32(seed)};
        TrendStore store(longestJoin);
        BruteForce truth;
        qint64 time = qint64(random() % 10'000) - 5'000;
        const qint64 start = time;
        const int samples = int(random() % 6'000) + 1;
        for (int i = 0; i < samples; ++i) {
            // Mostly dense, some at the same instant, sometimes exactly at or just over the longest join.
            const quint32 dice = random() % 200;
            time += dice == 0 ? longestJoin + 1 : dice == 1 ? longestJoin : dice < 20 ? 0 : random() % 5;
            const Measurement sample = randomSample(random, time);
            store.append(sample);
            truth.append(sample);
        }
        const qint64 span = time - start + 1;
        for (int window = 0; window < 25; ++window) {
            const qint64 from = start + qint64(random() % quint64(span * 2)) - span / 2;
            const qint64 to = from + 1 + qint64(random() % quint64(span * (window % 3 == 0 ? 3 : 1)));
            const int count = window % 5 == 0 ? 1 : 1 + int(random() % 300);
            compare(store, truth, from, to, count);
            if (QTest::currentTestFailed())
                return;
        }
        compare(store, truth, start, time + 1, 40);
    }
}

void TrendStoreBruteForceTest::growingStoresAnswerTheSameAtEveryLength()
{
    std::mt19937 random{77};
    TrendStore store(longestJoin);
    BruteForce truth;
    for (int length = 1; length <= 600; ++length) { // past two levels of the pyramid
        const Measurement sample = randomSample(random, length * 3);
        store.append(sample);
        truth.append(sample);
        compare(store, truth, 0, length * 3 + 1, 1 + length % 7);
        if (QTest::currentTestFailed())
            return;
    }
}

QTEST_APPLESS_MAIN(TrendStoreBruteForceTest)
#include "tst_trend_store_brute_force.moc"

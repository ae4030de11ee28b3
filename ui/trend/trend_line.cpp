#include "trend_line.h"

#include <algorithm>
#include <cmath>

namespace lds::ui {

using measurement::Measurement;
using measurement::TrendColumn;
using measurement::TrendStore;

namespace {

// TrendStore's own default: neighbours further apart are not joined.
constexpr qint64 longestJoinNs = 1'000'000'000;

bool joins(const Measurement& one, const Measurement& next)
{
    return one.hasValue() && next.hasValue() && next.monotonicNs - one.monotonicNs <= longestJoinNs;
}

/// Collects points into segments.
class LineBuilder {
public:
    explicit LineBuilder(const PlotScale& scale)
        : m_scale(scale)
    {}

    void breakLine() { m_open = false; }

    void add(qint64 ns, double value, bool frozen)
    {
        const QPointF point(m_scale.x(ns), m_scale.y(value));
        if (!m_open) {
            m_segments.append({frozen, {point}});
            m_open = true;
            return;
        }
        if (m_segments.last().frozen != frozen) {
            const QPointF join = m_segments.last().points.last();
            m_segments.append({frozen, {join}});
        }
        append(m_segments.last().points, point);
    }

    QList<TrendSegment> finished()
    {
        for (TrendSegment& segment : m_segments) {
            if (segment.points.size() == 1) { // a lone sample still is a dot
                const QPointF only = segment.points.first();
                segment.points = {only - QPointF(0.75, 0), only + QPointF(0.75, 0)};
            }
        }
        return m_segments;
    }

private:
    /// The middle of three equal values adds nothing but work.
    static void append(QList<QPointF>& points, const QPointF& point)
    {
        const auto count = points.size();
        if (count >= 2 && points[count - 1].y() == point.y() && points[count - 2].y() == point.y())
            points[count - 1] = point;
        else
            points.append(point);
    }

    const PlotScale& m_scale;
    QList<TrendSegment> m_segments;
    bool m_open = false;
};

template <typename Predicate>
QList<PixelRun> runsWhere(const TrendColumns& columns, const PlotScale& scale, Predicate isSet)
{
    QList<PixelRun> runs;
    std::optional<std::size_t> latest; // the last column with samples
    bool wasSet = false;
    for (std::size_t index = 0; index < columns.columns.size(); ++index) {
        const TrendColumn& column = columns.columns[index];
        if (column.samples == 0)
            continue;
        const double left = scale.x(columns.startNs(index));
        const double right = scale.x(columns.startNs(index + 1));
        const bool bridged = wasSet && qint64(index - *latest) * columns.columnNs <= longestJoinNs;
        if (bridged)
            runs.last().right = left;
        wasSet = isSet(column);
        if (wasSet && bridged)
            runs.last().right = right;
        else if (wasSet)
            runs.append({left, right});
        latest = index;
    }
    return runs;
}

} // namespace

TrendColumns readColumns(const TrendStore& store, const TrendSpan& span, int pixels)
{
    TrendColumns result;
    result.columnNs = std::max<qint64>(1, span.lengthNs() / pixels);
    qint64 rest = span.fromNs % result.columnNs;
    if (rest < 0)
        rest += result.columnNs;
    result.fromNs = span.fromNs - rest;
    const auto count = int((span.toNs - result.fromNs) / result.columnNs) + 1;
    const qint64 toNs = result.startNs(std::size_t(count));
    result.columns = store.columns(result.fromNs, toNs, count);

    const std::size_t first = store.lowerBound(result.fromNs);
    if (first > 0 && first < store.size() && joins(store.at(first - 1), store.at(first)))
        result.before = store.at(first - 1);
    const std::size_t next = store.lowerBound(toNs);
    if (next > 0 && next < store.size() && joins(store.at(next - 1), store.at(next)))
        result.after = store.at(next);
    return result;
}

std::optional<TrendValueScale::Range> valueRange(const TrendColumns& columns)
{
    std::optional<TrendValueScale::Range> range;
    for (const TrendColumn& column : columns.columns) {
        if (!column.hasValue)
            continue;
        const double low = column.minimum;
        const double high = column.maximum;
        range = range ? TrendValueScale::Range{std::min(range->low, low), std::max(range->high, high)}
                      : TrendValueScale::Range{low, high};
    }
    return range;
}

std::optional<std::size_t> columnNear(const TrendColumns& columns, qint64 monotonicNs, int reach)
{
    const auto count = qint64(columns.columns.size());
    const qint64 middle = (monotonicNs - columns.fromNs) / columns.columnNs;
    for (int distance = 0; distance <= reach; ++distance) {
        for (const qint64 index : {middle - distance, middle + distance}) {
            if (index >= 0 && index < count && columns.columns[std::size_t(index)].samples > 0)
                return std::size_t(index);
        }
    }
    return std::nullopt;
}

double PlotScale::x(qint64 monotonicNs) const
{
    return double(monotonicNs - span.fromNs) / double(span.lengthNs()) * width;
}

double PlotScale::y(double value) const
{
    // Far outside is as good as further outside, and the rasteriser is spared huge coordinates.
    const double relative = std::clamp((value - range.low) / range.span(), -20.0, 21.0);
    return relative * height;
}

qint64 PlotScale::timeAt(double pixel) const
{
    return span.fromNs + qint64(pixel / width * double(span.lengthNs()));
}

double PlotScale::valueAt(double pixel) const { return range.low + pixel / height * range.span(); }

QList<TrendSegment> lineSegments(const TrendColumns& columns, const PlotScale& scale)
{
    LineBuilder line(scale);
    bool atStart = true;
    if (columns.before)
        line.add(columns.before->monotonicNs, columns.before->value, columns.before->isFrozen());
    for (std::size_t index = 0; index < columns.columns.size(); ++index) {
        const TrendColumn& column = columns.columns[index];
        if (!column.hasValue)
            continue;
        // What lies between the first column and the sample before it has been judged by readColumns().
        if (atStart ? !columns.before : column.gapBefore)
            line.breakLine();
        atStart = false;
        const qint64 ns = columns.middleNs(index);
        const bool frozen = column.hasFrozen;
        const bool rising = column.first <= column.last;
        line.add(ns, rising ? column.minimum : column.maximum, frozen);
        if (column.minimum != column.maximum)
            line.add(ns, rising ? column.maximum : column.minimum, frozen);
    }
    if (columns.after && (!atStart || columns.before)) // a window between two samples still shows the line
        line.add(columns.after->monotonicNs, columns.after->value, columns.after->isFrozen());
    return line.finished();
}

QList<PixelRun> stateRuns(const TrendColumns& columns, const PlotScale& scale, quint16 bits)
{
    return runsWhere(columns, scale,
                     [bits](const TrendColumn& column) { return (column.stateOr & bits) != 0; });
}

QList<PixelRun> frozenRuns(const TrendColumns& columns, const PlotScale& scale)
{
    return runsWhere(columns, scale, [](const TrendColumn& column) { return column.hasFrozen; });
}

} // namespace lds::ui

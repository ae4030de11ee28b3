#pragma once

#include "trend_store.h"
#include "trend_time_window.h"
#include "trend_value_scale.h"

#include <optional>
#include <QList>
#include <QPointF>
#include <vector>

namespace lds::ui {

/// What one frame of a trend is drawn from: one column for each pixel of the plot.
struct TrendColumns {
    qint64 fromNs = 0;   ///< Left edge of the first column, at or before the window.
    qint64 columnNs = 1; ///< Width of each.
    std::vector<measurement::TrendColumn> columns;
    std::optional<measurement::Measurement> before; ///< The sample before the first column …
    std::optional<measurement::Measurement> after; ///< … and after the last, where a line joins up with it.

    qint64 startNs(std::size_t index) const { return fromNs + qint64(index) * columnNs; }
    qint64 middleNs(std::size_t index) const { return startNs(index) + columnNs / 2; }
};

/// Columns lie on multiples of their width, so that samples keep their column while the window moves and
/// the line does not shimmer. `pixels` ≥ 1.
TrendColumns readColumns(const measurement::TrendStore& store, const TrendSpan& span, int pixels);

/// Smallest and largest value seen.
std::optional<TrendValueScale::Range> valueRange(const TrendColumns& columns);

/// The column at an instant that has samples, or the nearest such within `reach` columns.
std::optional<std::size_t> columnNear(const TrendColumns& columns, qint64 monotonicNs, int reach);

/// From time and value to the plot's pixels: x to the right, y upwards.
struct PlotScale {
    TrendSpan span;
    TrendValueScale::Range range;
    double width = 1;
    double height = 1;

    double x(qint64 monotonicNs) const;
    double y(double value) const;
    qint64 timeAt(double x) const;
    double valueAt(double y) const;
};

/// A piece of the line without a gap.
struct TrendSegment {
    bool frozen = false;   ///< Values held under an alarm (§4.7.2).
    QList<QPointF> points; ///< In the plot's pixels, at least two.
};
QList<TrendSegment> lineSegments(const TrendColumns& columns, const PlotScale& scale);

/// A stretch of the plot, in pixels.
struct PixelRun {
    double left = 0;
    double right = 0;
};
/// Where one of `bits` was set. Empty columns between two samples continue the state before them.
QList<PixelRun> stateRuns(const TrendColumns& columns, const PlotScale& scale, quint16 bits);
/// Where values were held under an alarm.
QList<PixelRun> frozenRuns(const TrendColumns& columns, const PlotScale& scale);

} // namespace lds::ui

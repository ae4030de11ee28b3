#pragma once

#include "trend_time_window.h"
#include "trend_value_scale.h"

#include <QList>
#include <QString>

namespace lds::ui {

/// A place on an axis that gets a line and a label.
struct ValueTick {
    catalog::Value value = 0; ///< 0.1 µm
    QString text;             ///< mm, without unit
};
struct TimeTick {
    qint64 monotonicNs = 0;
    QString text;
};

/// The smallest of 1, 2, 5 × 10ⁿ not below `least`, at least 1.
qint64 niceStep(double least);

/// Ticks in `range`, at most `most` of them (≥ 2), at round values, all with the same decimals.
QList<ValueTick> valueTicks(const TrendValueScale::Range& range, int most);

/// Ticks at round wall-clock times of the local time zone; at most `most` (≥ 2). `wallOffsetNs` is wall
/// time (ns since the epoch, UTC) minus monotonic time. A tick at midnight carries the date.
QList<TimeTick> timeTicks(const TrendSpan& span, qint64 wallOffsetNs, int most);

/// "10:21:04.123": local wall-clock time with as many decimals as `resolutionNs` asks for (0 or 1 … 3).
QString clockText(qint64 wallNs, qint64 resolutionNs);

/// "250 ms", "10 s", "1 min", "2 h 5 min": a length of time in at most two units.
QString durationText(qint64 ns);

} // namespace lds::ui

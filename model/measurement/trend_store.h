#pragma once

#include "measurement.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lds::measurement {

/// What falls into one pixel column of a trend.
struct TrendColumn {
    bool hasValue = false;    ///< False: nothing measured here, the line has a gap.
    Value minimum = 0;        ///< 0.1 µm, over the valid samples of the column.
    Value maximum = 0;
    Value first = 0;          ///< First and last valid value, so that the line can be joined up.
    Value last = 0;
    bool gapBefore = false;   ///< A sample without a value, or a pause in the stream, lies between the
                              ///< previous column's last value and this one's first.
    quint16 stateOr = 0;      ///< StateBits that were set at least once.
    quint32 samples = 0;
};

/// All samples of one sensor with a min/max pyramid over them.
///
/// append() is amortised O(1). Memory is at most 20 bytes a sample, all in. columns() costs
/// O(columns · log(samples)) whatever is stored. Times are monotonic nanoseconds and never go back; a
/// sample older than the last is stamped with the last's time. Not thread-safe: it lives with its session.
class TrendStore {
public:
    /// Two neighbours further apart than this are not joined by a line.
    explicit TrendStore(qint64 longestJoinNs = 1'000'000'000);

    void append(const Measurement& sample);
    void clear();

    std::size_t size() const;
    bool isEmpty() const { return size() == 0; }
    qint64 firstNs() const;              ///< 0 when empty
    qint64 lastNs() const;
    Measurement at(std::size_t index) const; ///< wall time is reconstructed to the millisecond
    std::size_t lowerBound(qint64 monotonicNs) const; ///< first sample at or after; size() when none

    /// Splits [fromNs, toNs) into `count` equal columns. count ≥ 1, fromNs < toNs.
    std::vector<TrendColumn> columns(qint64 fromNs, qint64 toNs, int count) const;

    struct Range { Value minimum; Value maximum; };
    /// Smallest and largest valid value in [fromNs, toNs); nothing when there is none.
    std::optional<Range> range(qint64 fromNs, qint64 toNs) const;

    /// Bytes held, capacity included, for the 20 bytes' promise.
    std::size_t bytes() const;
};

} // namespace lds::measurement

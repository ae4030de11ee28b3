#pragma once

#include "chunked_array.h"
#include "measurement.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace lds::measurement {

/// What falls into one pixel column of a trend.
struct TrendColumn {
    bool hasValue = false; ///< False: nothing measured here, the line has a gap.
    Value minimum = 0;     ///< 0.1 µm, over the valid samples of the column.
    Value maximum = 0;
    Value first = 0; ///< First and last valid value, so that the line can be joined up.
    Value last = 0;
    bool gapBefore = false; ///< A sample without a value, or a pause in the stream, lies between the
                            ///< last value of the nearest earlier column that has one and this one's
                            ///< first. True as well for the first column of a window that has a value.
                            ///< Columns without a value are false.
    quint16 stateOr = 0;    ///< StateBits that were set at least once, in samples without a value too.
    quint32 samples = 0;    ///< With and without a value.
    bool hasFrozen = false; ///< One of the values is frozen (§4.7.2); stateOr cannot tell, since an alarm
                            ///< without a value in the same column sets the same bit.
    friend bool operator==(const TrendColumn&, const TrendColumn&) = default;
};

/// All samples of one sensor with a min/max pyramid over them.
///
/// append() is amortised O(1). Memory is at most 20 bytes a sample, all in, beside a fixed 16 KiB.
/// columns() costs O(columns · log(samples)) whatever is stored. Times are monotonic nanoseconds and never
/// go back; a sample older than the last is stamped with the last's time. A frozen value (§4.7.2) is a value
/// here: it stands on the sensor's display, and its alarm bit tells. Not thread-safe: it lives with its
/// session.
class TrendStore {
public:
    /// Two neighbours further apart than this are not joined by a line.
    explicit TrendStore(qint64 longestJoinNs = 1'000'000'000);

    void append(const Measurement& sample);
    void clear();

    std::size_t size() const { return m_samples.size(); }
    bool isEmpty() const { return size() == 0; }
    qint64 firstNs() const; ///< 0 when empty
    qint64 lastNs() const;  ///< 0 when empty
    /// Time, value, kind, state and intensity (up to 16382; anything above reads as none) of a sample.
    /// Its wall time is reconstructed to the millisecond; it follows a wall clock that is set, though not
    /// more often than every 64 samples. Notification, caution and error come back as their bits in the
    /// state only; their details and the error code are not kept. `index` < size().
    Measurement at(std::size_t index) const;
    std::size_t lowerBound(qint64 monotonicNs) const; ///< first sample at or after; size() when none

    /// Splits [fromNs, toNs) into `count` equal columns. Empty unless count ≥ 1 and fromNs < toNs.
    std::vector<TrendColumn> columns(qint64 fromNs, qint64 toNs, int count) const;

    struct Range {
        Value minimum;
        Value maximum;
        friend bool operator==(const Range&, const Range&) = default;
    };
    /// Smallest and largest valid value in [fromNs, toNs); nothing when there is none.
    std::optional<Range> range(qint64 fromNs, qint64 toNs) const;

    /// Bytes held, capacity included, for the 20 bytes' promise.
    std::size_t bytes() const;

private:
    struct Sample {
        qint64 timeNs;
        Value value;
        quint32 packed; ///< State, kind, pause and intensity: see packedOf().
    };

    /// What is known of a stretch of samples without looking at them.
    struct Node {
        Value minimum = 0; ///< With minimum and maximum meaningless unless hasValue.
        Value maximum = 0;
        quint16 stateOr = 0;
        bool hasValue : 1 = false;
        bool hasFrozen : 1 = false;
        bool hasGap = false; ///< A sample without a value, or one after a pause.
        void add(const Node& later);
    };

    struct WallAnchor {
        std::size_t index;   ///< From this sample on
        qint64 wallOffsetMs; ///< is the wall time so much ahead of the monotonic time.
    };

    static constexpr std::size_t fanOut = 16;
    using Level = ChunkedArray<Node, 64>;

    static quint32 packedOf(const Measurement& sample, bool afterPause);
    static Node nodeOf(const Sample& sample);
    Node nodeAt(std::size_t level, std::size_t index) const;
    void buildNodes();
    void noteWallTime(const Measurement& sample, qint64 timeNs);

    /// Calls visit(level, index, node) for the fewest stretches that make up samples [begin, end), in order.
    template <typename Visit>
    void forEachStretch(std::size_t begin, std::size_t end, Visit visit) const;
    Node fold(std::size_t begin, std::size_t end) const;
    std::size_t firstValue(std::size_t level, std::size_t index) const; ///< in a node that has one
    std::size_t lastValue(std::size_t level, std::size_t index) const;
    TrendColumn column(std::size_t begin, std::size_t end, std::optional<std::size_t>& lastValueBefore) const;

    qint64 m_longestJoinNs;
    ChunkedArray<Sample, 256> m_samples;
    std::vector<Level> m_levels; ///< m_levels[0] has a node for every 16 samples, [1] for every 256, …
                                 ///< Complete ones only, so that append() touches none most of the time.
    std::vector<WallAnchor> m_wallAnchors;
};

} // namespace lds::measurement

#include "trend_store.h"

#include <algorithm>

namespace lds::measurement {

namespace {

// A sample's packed word, from the lowest bit: 14 bits of state, 3 of kind, 1 pause, 14 of intensity.
constexpr quint32 stateMask = 0x3fff;
constexpr int kindShift = 14;
constexpr quint32 kindMask = 0x7;
constexpr int pauseShift = 17;
constexpr int intensityShift = 18;
constexpr quint16 noPackedIntensity = 0x3fff;
constexpr quint16 noIntensity = 65535; // §5.2.4, 400022

static_assert((stateMask & ReservedStateBits) == 0 && (stateMask | ReservedStateBits) == 0xffff);
static_assert(quint32(ValueKind::Alarm) <= kindMask);

ValueKind kindIn(quint32 packed) { return ValueKind((packed >> kindShift) & kindMask); }

constexpr qint64 nsInMs = 1'000'000;
constexpr std::size_t samplesPerWallAnchor = 64;

/// Start of column `k` of `count` over [fromNs, fromNs + span): exact, and without overflow since the
/// remainder is below `count`.
qint64 columnStart(qint64 fromNs, quint64 span, quint64 count, quint64 k)
{
    const quint64 offset = span / count * k + span % count * k / count;
    return qint64(quint64(fromNs) + offset);
}

} // namespace

void TrendStore::Node::add(const Node& later)
{
    if (later.hasValue) {
        minimum = hasValue ? std::min(minimum, later.minimum) : later.minimum;
        maximum = hasValue ? std::max(maximum, later.maximum) : later.maximum;
        hasValue = true;
    }
    stateOr |= later.stateOr;
    hasGap |= later.hasGap;
    hasFrozen = hasFrozen || later.hasFrozen;
}

TrendStore::TrendStore(qint64 longestJoinNs)
    : m_longestJoinNs(longestJoinNs)
{}

void TrendStore::append(const Measurement& sample)
{
    const qint64 timeNs = isEmpty() ? sample.monotonicNs : std::max(sample.monotonicNs, lastNs());
    const bool afterPause = !isEmpty() && quint64(timeNs) - quint64(lastNs()) > quint64(m_longestJoinNs);
    noteWallTime(sample, timeNs);
    m_samples.append({timeNs, sample.value, packedOf(sample, afterPause)});
    buildNodes();
}

void TrendStore::clear() { *this = TrendStore(m_longestJoinNs); }

qint64 TrendStore::firstNs() const { return isEmpty() ? 0 : m_samples[0].timeNs; }

qint64 TrendStore::lastNs() const { return isEmpty() ? 0 : m_samples.last().timeNs; }

Measurement TrendStore::at(std::size_t index) const
{
    const Sample& sample = m_samples[index];
    const auto after =
        std::upper_bound(m_wallAnchors.begin(), m_wallAnchors.end(), index,
                         [](std::size_t i, const WallAnchor& anchor) { return i < anchor.index; });
    const quint16 intensity = quint16(sample.packed >> intensityShift);
    Measurement measurement;
    measurement.monotonicNs = sample.timeNs;
    measurement.wallMs = sample.timeNs / nsInMs + std::prev(after)->wallOffsetMs;
    measurement.value = sample.value;
    measurement.kind = kindIn(sample.packed);
    measurement.state = quint16(sample.packed & stateMask);
    measurement.intensity = intensity == noPackedIntensity ? noIntensity : intensity;
    return measurement;
}

std::size_t TrendStore::lowerBound(qint64 monotonicNs) const
{
    std::size_t begin = 0;
    std::size_t length = size();
    while (length > 0) {
        const std::size_t half = length / 2;
        if (m_samples[begin + half].timeNs < monotonicNs) {
            begin += half + 1;
            length -= half + 1;
        } else {
            length = half;
        }
    }
    return begin;
}

std::vector<TrendColumn> TrendStore::columns(qint64 fromNs, qint64 toNs, int count) const
{
    std::vector<TrendColumn> columns;
    if (count < 1 || fromNs >= toNs)
        return columns;
    columns.reserve(std::size_t(count));
    const quint64 span = quint64(toNs) - quint64(fromNs);
    std::optional<std::size_t> lastValueBefore;
    std::size_t begin = lowerBound(fromNs);
    for (int k = 1; k <= count; ++k) {
        const std::size_t end = lowerBound(columnStart(fromNs, span, quint64(count), quint64(k)));
        columns.push_back(column(begin, end, lastValueBefore));
        begin = end;
    }
    return columns;
}

std::optional<TrendStore::Range> TrendStore::range(qint64 fromNs, qint64 toNs) const
{
    if (fromNs >= toNs)
        return std::nullopt;
    const Node node = fold(lowerBound(fromNs), lowerBound(toNs));
    return node.hasValue ? std::optional(Range{node.minimum, node.maximum}) : std::nullopt;
}

std::size_t TrendStore::bytes() const
{
    std::size_t bytes = sizeof *this + m_samples.bytes() + m_levels.capacity() * sizeof(Level) +
                        m_wallAnchors.capacity() * sizeof(WallAnchor);
    for (const Level& level : m_levels)
        bytes += level.bytes();
    return bytes;
}

quint32 TrendStore::packedOf(const Measurement& sample, bool afterPause)
{
    const quint16 intensity = std::min(sample.intensity, noPackedIntensity);
    return (sample.state & stateMask) | quint32(sample.kind) << kindShift |
           quint32(afterPause) << pauseShift | quint32(intensity) << intensityShift;
}

TrendStore::Node TrendStore::nodeOf(const Sample& sample)
{
    Node node;
    node.minimum = node.maximum = sample.value;
    node.stateOr = quint16(sample.packed & stateMask);
    node.hasValue = kindIn(sample.packed) == ValueKind::Valid;
    node.hasFrozen = node.hasValue && (node.stateOr & AlarmBit) != 0;
    node.hasGap = !node.hasValue || ((sample.packed >> pauseShift) & 1) != 0;
    return node;
}

/// Level 0 are the samples themselves.
TrendStore::Node TrendStore::nodeAt(std::size_t level, std::size_t index) const
{
    return level == 0 ? nodeOf(m_samples[index]) : m_levels[level - 1][index];
}

/// Completes the nodes that the newest sample is the last of: one append in 16 makes one, one in 256 two, …
void TrendStore::buildNodes()
{
    std::size_t length = size();
    for (std::size_t level = 0; length % fanOut == 0; ++level) {
        Node node;
        for (std::size_t child = length - fanOut; child < length; ++child)
            node.add(nodeAt(level, child));
        if (m_levels.size() == level)
            m_levels.emplace_back();
        m_levels[level].append(node);
        length /= fanOut;
    }
}

void TrendStore::noteWallTime(const Measurement& sample, qint64 timeNs)
{
    const qint64 offset = sample.wallMs - timeNs / nsInMs;
    // The two clocks' milliseconds need not begin together, so one of difference is none.
    if (!m_wallAnchors.empty() && std::abs(offset - m_wallAnchors.back().wallOffsetMs) <= 1)
        return;
    if (m_wallAnchors.size() * samplesPerWallAnchor <= size())
        m_wallAnchors.push_back({size(), offset});
}

template <typename Visit>
void TrendStore::forEachStretch(std::size_t begin, std::size_t end, Visit visit) const
{
    while (begin < end) {
        std::size_t level = 0;
        std::size_t length = 1;
        std::size_t longer = fanOut;
        while (level < m_levels.size() && begin % longer == 0 && longer <= end - begin) {
            ++level;
            length = longer;
            longer *= fanOut;
        }
        visit(level, begin / length, nodeAt(level, begin / length));
        begin += length;
    }
}

TrendStore::Node TrendStore::fold(std::size_t begin, std::size_t end) const
{
    Node sum;
    forEachStretch(begin, end, [&](std::size_t, std::size_t, const Node& node) { sum.add(node); });
    return sum;
}

std::size_t TrendStore::firstValue(std::size_t level, std::size_t index) const
{
    for (; level > 0; --level) {
        index *= fanOut;
        while (!nodeAt(level - 1, index).hasValue)
            ++index;
    }
    return index;
}

std::size_t TrendStore::lastValue(std::size_t level, std::size_t index) const
{
    for (; level > 0; --level) {
        index = index * fanOut + fanOut - 1;
        while (!nodeAt(level - 1, index).hasValue)
            --index;
    }
    return index;
}

TrendColumn TrendStore::column(std::size_t begin, std::size_t end,
                               std::optional<std::size_t>& lastValueBefore) const
{
    struct Place {
        std::size_t level;
        std::size_t index;
    };
    std::optional<Place> first;
    std::optional<Place> last;
    Node sum;
    forEachStretch(begin, end, [&](std::size_t level, std::size_t index, const Node& node) {
        sum.add(node);
        if (!node.hasValue)
            return;
        last = Place{level, index};
        if (!first)
            first = last;
    });

    TrendColumn column;
    column.samples = quint32(end - begin);
    column.stateOr = sum.stateOr;
    column.hasValue = sum.hasValue;
    column.hasFrozen = sum.hasFrozen;
    if (!sum.hasValue)
        return column;
    const std::size_t firstIndex = firstValue(first->level, first->index);
    const std::size_t lastIndex = lastValue(last->level, last->index);
    column.minimum = sum.minimum;
    column.maximum = sum.maximum;
    column.first = m_samples[firstIndex].value;
    column.last = m_samples[lastIndex].value;
    column.gapBefore = !lastValueBefore || fold(*lastValueBefore + 1, firstIndex + 1).hasGap;
    lastValueBefore = lastIndex;
    return column;
}

} // namespace lds::measurement

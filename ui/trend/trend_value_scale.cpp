#include "trend_value_scale.h"

#include "trend_ticks.h"

#include <algorithm>
#include <cmath>

namespace lds::ui {

namespace {

using Range = TrendValueScale::Range;

// HIGH and LOW from far off are fitted in where the line still fills this part of the height; once fitted
// in they stay until the line has become clearly flatter.
constexpr double flattestToFitLimits = 1.0 / 10;
constexpr double flattestToKeepLimits = 1.0 / 20;
// A narrower fit is worth a jump of the axis only when it gains this much.
constexpr double worthNarrowing = 0.7;

Range withRoom(Range range)
{
    const double missing = TrendValueScale::smallestSpan - range.span();
    if (missing > 0) {
        range.low -= missing / 2;
        range.high += missing / 2;
    }
    const double room = range.span() * 0.06;
    return {range.low - room, range.high + room};
}

/// Ends on whole parts of a tick step, so that small changes of the data do not move the axis.
Range snapped(const Range& range)
{
    const double part = std::max(1.0, double(niceStep(range.span() / 5)) / 5);
    return {std::floor(range.low / part) * part, std::ceil(range.high / part) * part};
}

Range united(const Range& one, const Range& other)
{
    return {std::min(one.low, other.low), std::max(one.high, other.high)};
}

} // namespace

void TrendValueScale::fit(std::optional<Range> data, const Limits& limits, qint64 nowNs)
{
    if (!m_automatic)
        return;
    if (!data && !m_exact)
        return; // nothing to see: no reason to move
    const Range target = wanted(data, limits);
    if (m_exact) {
        m_range = target;
        m_exact = !data;
        m_narrowsAtNs.reset();
        return;
    }
    if (target.low < m_range.low || target.high > m_range.high)
        m_range = united(m_range, target);
    if (target.span() >= m_range.span() * worthNarrowing) {
        m_narrowsAtNs.reset();
    } else if (!m_narrowsAtNs) {
        m_narrowsAtNs = nowNs + narrowingDelayNs;
    } else if (nowNs >= *m_narrowsAtNs) {
        m_range = target;
        m_narrowsAtNs.reset();
    }
}

Range TrendValueScale::wanted(std::optional<Range> data, const Limits& limits)
{
    if (limits.values.isEmpty())
        return data ? snapped(withRoom(*data)) : Range{-10'000, 10'000};
    const auto [low, high] = std::minmax_element(limits.values.begin(), limits.values.end());
    const Range window{double(*low), double(*high)};
    if (!data)
        return snapped(withRoom(window));
    m_limitsFitted = shouldFitLimits(*data, window, limits.sayLittle);
    return snapped(withRoom(m_limitsFitted ? united(*data, window) : *data));
}

bool TrendValueScale::shouldFitLimits(const Range& data, const Range& window, bool sayLittle) const
{
    const bool about = data.high >= window.low - window.span() && data.low <= window.high + window.span();
    if (about && !sayLittle)
        return true;
    const double flattest = m_limitsFitted ? flattestToKeepLimits : flattestToFitLimits;
    return data.span() >= united(data, window).span() * flattest;
}

void TrendValueScale::setAutomatic()
{
    m_automatic = true;
    m_exact = true;
    m_limitsFitted = false;
    m_narrowsAtNs.reset();
}

void TrendValueScale::zoomBy(double factor, double anchor)
{
    const double span = std::clamp(m_range.span() * factor, smallestSpan, largestSpan);
    const double real = span / m_range.span();
    setRange({anchor - (anchor - m_range.low) * real, anchor + (m_range.high - anchor) * real});
}

void TrendValueScale::panBy(double difference)
{
    setRange({m_range.low + difference, m_range.high + difference});
}

void TrendValueScale::setRange(const Range& range)
{
    m_automatic = false;
    m_narrowsAtNs.reset();
    const double span = range.span();
    const double low = std::clamp(range.low, -largestSpan, largestSpan - span);
    m_range = {low, low + span};
}

} // namespace lds::ui

#include "trend_time_window.h"

#include <algorithm>
#include <cmath>

namespace lds::ui {

TrendSpan TrendTimeWindow::span(const TrendSpan& data) const
{
    if (m_paused)
        return m_frozen;
    if (m_all)
        return {data.fromNs, std::max(data.toNs, data.fromNs + shortestAllNs)};
    const qint64 to = m_following ? data.toNs : m_toNs;
    return {to - m_lengthNs, to};
}

void TrendTimeWindow::follow()
{
    m_following = true;
    m_paused = false;
}

void TrendTimeWindow::showAll(const TrendSpan& data)
{
    const bool paused = m_paused;
    m_paused = false;
    m_all = true;
    m_following = true;
    m_frozen = span(data);
    m_paused = paused;
}

void TrendTimeWindow::setLength(qint64 lengthNs, const TrendSpan& data)
{
    const qint64 to = span(data).toNs;
    m_lengthNs = std::clamp(lengthNs, shortestNs, longestNs);
    m_all = false;
    m_toNs = to;
    m_frozen = {to - m_lengthNs, to};
}

void TrendTimeWindow::setPaused(bool paused, const TrendSpan& data)
{
    if (paused == m_paused)
        return;
    if (paused)
        m_frozen = span(data);
    m_paused = paused;
}

void TrendTimeWindow::panBy(qint64 ns, const TrendSpan& data)
{
    const TrendSpan now = span(data);
    panTo({now.fromNs + ns, now.toNs + ns}, data);
}

void TrendTimeWindow::panTo(const TrendSpan& wanted, const TrendSpan& data)
{
    m_following = false;
    place(wanted, data);
}

void TrendTimeWindow::zoomBy(double factor, double fraction, const TrendSpan& data)
{
    const TrendSpan now = span(data);
    const auto length =
        qint64(std::clamp(double(now.lengthNs()) * factor, double(shortestNs), double(longestNs)));
    const double anchor = double(now.lengthNs()) * std::clamp(fraction, 0.0, 1.0);
    const qint64 from = now.fromNs + qint64(anchor - double(length) * std::clamp(fraction, 0.0, 1.0));
    const TrendSpan wanted{from, from + length};
    if (m_following && !m_paused && wanted.toNs >= now.toNs) {
        m_all = false;
        m_lengthNs = length;
        return;
    }
    m_following = false;
    place(wanted, data);
}

/// Some of what is stored always stays in sight, so that nobody gets lost in empty time.
void TrendTimeWindow::place(TrendSpan wanted, const TrendSpan& data)
{
    const qint64 length = wanted.lengthNs();
    const qint64 to = std::clamp(wanted.toNs, data.fromNs + length / 10, data.toNs + length * 9 / 10);
    m_all = false;
    m_lengthNs = length;
    m_toNs = to;
    m_frozen = {to - length, to};
}

} // namespace lds::ui

#include "measurement_rate.h"

#include <algorithm>

namespace lds::sensor {

namespace {
constexpr qint64 windowNs = 1'000'000'000;
} // namespace

void MeasurementRate::add(const measurement::MeasurementBatch& batch)
{
    for (const measurement::Measurement& sample : batch)
        m_times.push_back(sample.monotonicNs);
    // One older than the window stays: it tells that the stream is as long as the window.
    while (m_times.size() > 1 && m_times[1] <= m_times.back() - windowNs)
        m_times.pop_front();
}

double MeasurementRate::perSecond(qint64 nowNs) const
{
    const auto first = std::upper_bound(m_times.begin(), m_times.end(), nowNs - windowNs);
    const auto inWindow = m_times.end() - first;
    if (inWindow == 0)
        return 0.0;
    if (first != m_times.begin()) // a whole window long
        return double(inWindow) * 1e9 / double(windowNs);
    const qint64 span = m_times.back() - *first;
    return span > 0 ? double(inWindow - 1) * 1e9 / double(span) : 0.0;
}

} // namespace lds::sensor

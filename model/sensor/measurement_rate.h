#pragma once

#include "measurement.h"

#include <deque>

namespace lds::sensor {

/// Measurements per second over the last second.
class MeasurementRate {
public:
    void add(const measurement::MeasurementBatch& batch);
    void clear() { m_times.clear(); }
    /// 1/s. While there is less than a second to look back on, over what there is.
    double perSecond(qint64 nowNs) const;

private:
    std::deque<qint64> m_times; ///< Receipt, monotonic ns, ascending, no older than the window.
};

} // namespace lds::sensor

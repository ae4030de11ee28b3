#pragma once

#include "trend_time_window.h"
#include "trend_value_scale.h"

#include <optional>

namespace lds::ui {

/// How one sensor's trend is looked at; kept for each sensor while another one is shown.
struct TrendView {
    TrendTimeWindow time;
    TrendValueScale values;
    /// Wall time (ns since the epoch) minus monotonic time. Kept, because a wall time rounded to the
    /// millisecond with every sample would make the time axis tremble.
    std::optional<qint64> wallOffsetNs;
};

} // namespace lds::ui

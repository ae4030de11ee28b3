#pragma once

#include "sensor_session.h"
#include "trend_scene.h"

namespace lds::ui {

/// Why there is no line, or why it does not go on, and what to do about it; empty when all is well.
/// `session` may be nullptr.
TrendNotice noticeFor(const sensor::SensorSession* session);

/// HIGH and LOW as the sensor holds them and as a person wants them.
TrendLimits limitsOf(const sensor::SensorSession& session);

} // namespace lds::ui

#pragma once

#include "display_content.h"

#include <QRectF>

class QPainter;

namespace lds::emulator {

/// Width of the display by its height.
inline constexpr double displayAspect = 2.0;

/// Draws what the sensor's display shows into `rect`: light on black, sharp at every size, upside down when
/// it is inverted. `rect` has the aspect above.
void paintDisplay(QPainter& painter, const QRectF& rect, const DisplayContent& content);

/// The same in words, for those who cannot see it; empty while the display is off.
QString spokenDisplay(const DisplayContent& content);

} // namespace lds::emulator

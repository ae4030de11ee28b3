#pragma once

#include "trend_scene.h"

class QPainter;

/// Paints what QtCharts does not: what lies below and above the line. Axis labels, HIGH and LOW and the
/// strip of states are painted here because a chart lays its axes out anew with every change of range.
namespace lds::ui {

void paintBelowLine(QPainter& painter, const TrendScene& scene); ///< Ground, band, grid, frozen stretches.
void paintAboveLine(QPainter& painter, const TrendScene& scene); ///< Limits, labels, states, notice, pointer.

} // namespace lds::ui

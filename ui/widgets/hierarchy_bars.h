#pragma once

#include <QRect>
#include <QSize>

class QPainter;

namespace lds::ui {

/// The sensor's hierarchical level display bar (§2.2): three bars, `level` of them lit (1 … 3).
/// Left-aligned and vertically centred in `rect`.
void paintHierarchyBars(QPainter* painter, const QRect& rect, int level);
/// The space the bars take.
QSize hierarchyBarsSize();

} // namespace lds::ui

#include "hierarchy_bars.h"

#include "theme.h"

#include <QPainter>

namespace lds::ui {

namespace {
constexpr int barCount = 3;
constexpr int barWidth = 8;
constexpr int barHeight = 3;
constexpr int barGap = 2;
} // namespace

void paintHierarchyBars(QPainter* painter, const QRect& rect, int level)
{
    const int top = rect.top() + (rect.height() - barHeight) / 2;
    for (int bar = 0; bar < barCount; ++bar) {
        painter->fillRect(rect.left() + bar * (barWidth + barGap), top, barWidth, barHeight,
                          color(bar < level ? ColorRole::Accent : ColorRole::Line));
    }
}

QSize hierarchyBarsSize() { return {barCount * barWidth + (barCount - 1) * barGap, barHeight}; }

} // namespace lds::ui

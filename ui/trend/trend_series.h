#pragma once

#include "trend_line.h"

#include <QLineSeries>
#include <QList>
#include <QPen>
#include <QSizeF>

class QChart;
class QValueAxis;

namespace lds::ui {

/// The line in the chart. A QLineSeries has no gaps, so each piece of the line is a series of its own,
/// from a pool that grows as needed: measured, 600 series of 4 points cost what one of 2,400 does.
///
/// The chart's axes are the plot's pixels and change only with its size. Were they time and value, moving
/// them with every frame would compute every point's place three times (replace, x range, y range).
class TrendSeries {
public:
    explicit TrendSeries(QChart& chart); ///< The chart outlives it and owns its series and axes.

    void setPlotSize(const QSizeF& size);
    void setColors(const QColor& live, const QColor& frozen);
    /// True when the line was so dense that antialiasing it would only cost time.
    bool show(const QList<TrendSegment>& segments);
    const QList<QLineSeries*>& pool() const { return m_pool; }

private:
    QLineSeries* addSeries();
    bool isDense(const QList<TrendSegment>& segments) const;
    void updatePens();

    QChart& m_chart;
    QValueAxis* m_x;
    QValueAxis* m_y;
    QList<QLineSeries*> m_pool;
    QList<bool> m_isFrozen; ///< The pen each series has.
    QSizeF m_plotSize;
    QColor m_liveColor;
    QColor m_frozenColor;
    QPen m_live;
    QPen m_frozen;
    bool m_dense = false;
};

} // namespace lds::ui

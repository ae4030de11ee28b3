#include "trend_series.h"

#include <cmath>
#include <QChart>
#include <QValueAxis>

namespace lds::ui {

TrendSeries::TrendSeries(QChart& chart)
    : m_chart(chart)
    , m_x(new QValueAxis(&chart))
    , m_y(new QValueAxis(&chart))
{
    m_chart.addAxis(m_x, Qt::AlignBottom);
    m_chart.addAxis(m_y, Qt::AlignLeft);
    m_x->hide();
    m_y->hide();
    addSeries();
}

void TrendSeries::setPlotSize(const QSizeF& size)
{
    m_plotSize = size;
    m_x->setRange(0, size.width());
    m_y->setRange(0, size.height());
}

void TrendSeries::setColors(const QColor& live, const QColor& frozen)
{
    m_liveColor = live;
    m_frozenColor = frozen;
    updatePens();
}

bool TrendSeries::show(const QList<TrendSegment>& segments)
{
    if (const bool dense = isDense(segments); dense != m_dense) {
        m_dense = dense;
        updatePens();
    }
    while (m_pool.size() < segments.size())
        addSeries();
    for (int index = 0; index < m_pool.size(); ++index) {
        QLineSeries* series = m_pool[index];
        if (index >= segments.size()) {
            if (series->count() > 0)
                series->replace(QList<QPointF>());
            continue;
        }
        if (m_isFrozen[index] != segments[index].frozen) {
            m_isFrozen[index] = segments[index].frozen;
            series->setPen(segments[index].frozen ? m_frozen : m_live);
        }
        series->replace(segments[index].points);
    }
    return m_dense;
}

/// A line that runs up and down in every pixel column is a filled band: measured, a pen of one plain
/// pixel paints it in a third of the time and nobody sees a difference.
bool TrendSeries::isDense(const QList<TrendSegment>& segments) const
{
    constexpr double mostTravel = 60; // times the plot's height
    double travel = 0;
    for (const TrendSegment& segment : segments) {
        for (qsizetype index = 1; index < segment.points.size(); ++index)
            travel += std::abs(segment.points[index].y() - segment.points[index - 1].y());
    }
    return travel > mostTravel * m_plotSize.height();
}

void TrendSeries::updatePens()
{
    m_live = QPen(m_liveColor, m_dense ? 1 : 1.5, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin);
    m_frozen = QPen(m_frozenColor, m_dense ? 1 : 2.5, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin);
    if (!m_dense)
        m_frozen.setDashPattern({3, 1.5});
    for (int index = 0; index < m_pool.size(); ++index)
        m_pool[index]->setPen(m_isFrozen[index] ? m_frozen : m_live);
}

QLineSeries* TrendSeries::addSeries()
{
    auto* series = new QLineSeries(&m_chart);
    m_chart.addSeries(series);
    series->attachAxis(m_x);
    series->attachAxis(m_y);
    series->setPen(m_live);
    m_pool.append(series);
    m_isFrozen.append(false);
    return series;
}

} // namespace lds::ui

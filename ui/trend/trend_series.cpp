#include "trend_series.h"

#include <QChart>
#include <QPen>
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
    m_x->setRange(0, size.width());
    m_y->setRange(0, size.height());
}

void TrendSeries::setColors(const QColor& live, const QColor& frozen)
{
    m_live = QPen(live, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin);
    m_frozen = QPen(frozen, 2.5, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin);
    m_frozen.setDashPattern({3, 1.5});
    for (int index = 0; index < m_pool.size(); ++index)
        m_pool[index]->setPen(m_isFrozen[index] ? m_frozen : m_live);
}

void TrendSeries::show(const QList<TrendSegment>& segments)
{
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

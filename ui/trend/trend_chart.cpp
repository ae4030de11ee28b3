#include "trend_chart.h"

#include "theme.h"
#include "trend_painter.h"

#include <algorithm>
#include <cstdlib>
#include <QChart>
#include <QGraphicsLayout>
#include <QLegend>
#include <QPainter>

namespace lds::ui {

namespace {

constexpr int valueTickSpacing = 36;
constexpr qint64 wallJumpNs = 20'000'000; ///< More than rounding: somebody set the clock.

QChart* bareChart()
{
    auto* chart = new QChart;
    chart->legend()->hide();
    chart->setBackgroundVisible(false);
    chart->setPlotAreaBackgroundVisible(false);
    chart->setAnimationOptions(QChart::NoAnimation);
    chart->setMargins({});
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    return chart;
}

} // namespace

TrendChart::TrendChart(QWidget* parent)
    : QChartView(bareChart(), parent)
    , m_series(*chart())
{
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(320, 200);
    setAccessibleName(tr("Trend of the measured value"));
    applyColors();
    connect(&Theme::instance(), &Theme::changed, this, &TrendChart::applyColors);
}

void TrendChart::setSource(const measurement::TrendStore* store, TrendView* view)
{
    m_store = store;
    m_view = view;
    m_drag = Drag::None;
    m_shownNs = -1;
    m_scene.pointer.reset();
    Q_EMIT viewChanged();
}

void TrendChart::setLimits(const TrendLimits& limits)
{
    if (m_scene.limits == limits)
        return;
    m_scene.limits = limits;
    Q_EMIT viewChanged();
}

void TrendChart::setNotice(const TrendNotice& notice)
{
    if (m_scene.notice == notice)
        return;
    m_scene.notice = notice;
    Q_EMIT viewChanged();
}

void TrendChart::setDecimals(int decimals) { m_scene.decimals = decimals; }

TrendSpan TrendChart::data() const
{
    return m_store && !m_store->isEmpty() ? TrendSpan{m_store->firstNs(), m_store->lastNs()} : TrendSpan{};
}

bool TrendChart::wantsFrame() const
{
    if (!m_store || !m_view || m_view->time.isPaused())
        return false;
    const TrendSpan stored = data();
    if (stored.toNs == m_shownNs)
        return false;
    const TrendSpan span = m_view->time.span(stored);
    return m_shownNs < span.toNs; // something new lies inside the window
}

void TrendChart::updateFrame(qint64 nowNs)
{
    m_scene.hasData = m_store && m_view && !m_store->isEmpty();
    viewport()->update();
    if (!m_scene.hasData) {
        m_shownNs = -1;
        m_series.show({});
        return;
    }
    const TrendSpan stored = data();
    m_shownNs = stored.toNs;
    PlotScale& scale = m_scene.scale;
    scale.width = m_scene.layout.plot.width();
    scale.height = m_scene.layout.plot.height();
    scale.span = m_view->time.span(stored);
    m_scene.columns = readColumns(*m_store, scale.span, std::max(1, int(scale.width)));

    TrendValueScale::Limits limits{{}, m_scene.limits.sayLittle};
    for (const TrendLimit* limit : {&m_scene.limits.high, &m_scene.limits.low}) {
        for (const auto& value : {limit->held, limit->wanted}) {
            if (value)
                limits.values.append(*value);
        }
    }
    m_view->values.fit(valueRange(m_scene.columns), limits, nowNs);
    scale.range = m_view->values.range();
    updateWallOffset(scale.span);
    prepareTicks();
    const bool dense = m_series.show(lineSegments(m_scene.columns, scale));
    setRenderHint(QPainter::Antialiasing, !dense);
    const std::array bits{measurement::HighBit, measurement::GoBit, measurement::LowBit,
                          measurement::AlarmBit};
    for (std::size_t row = 0; row < bits.size(); ++row)
        m_scene.states[row] = stateRuns(m_scene.columns, scale, bits[row]);
    m_scene.frozen = frozenRuns(m_scene.columns, scale);
}

void TrendChart::prepareTicks()
{
    const PlotScale& scale = m_scene.scale;
    m_scene.valueTicks = valueTicks(scale.range, std::max(2, int(scale.height) / valueTickSpacing));
    // Ticks finer than a second have longer labels, so there is room for fewer of them.
    for (const QString& widest : {QStringLiteral("00:00:00"), QStringLiteral("00:00:00.000")}) {
        const int room = fontMetrics().horizontalAdvance(widest) + 28;
        m_scene.timeTicks = timeTicks(scale.span, m_scene.wallOffsetNs, std::max(2, int(scale.width) / room));
        if (m_scene.timeTicks.isEmpty() || m_scene.timeTicks.last().text.size() <= widest.size())
            break;
    }
}

void TrendChart::updateWallOffset(const TrendSpan& span)
{
    const std::size_t after = m_store->lowerBound(span.toNs);
    const measurement::Measurement sample = m_store->at(after > 0 ? after - 1 : 0);
    const qint64 offset = sample.wallMs * 1'000'000 - sample.monotonicNs;
    if (!m_view->wallOffsetNs || std::abs(*m_view->wallOffsetNs - offset) > wallJumpNs)
        m_view->wallOffsetNs = offset;
    m_scene.wallOffsetNs = *m_view->wallOffsetNs;
}

void TrendChart::follow()
{
    if (!m_view)
        return;
    m_view->time.follow();
    m_view->values.setAutomatic();
    Q_EMIT viewChanged();
}

void TrendChart::fit()
{
    if (!m_view)
        return;
    m_view->time.follow();
    m_view->time.showAll(data());
    m_view->values.setAutomatic();
    Q_EMIT viewChanged();
}

void TrendChart::setPaused(bool paused)
{
    if (!m_view)
        return;
    m_view->time.setPaused(paused, data());
    Q_EMIT viewChanged();
}

void TrendChart::setWindowLength(qint64 ns)
{
    if (!m_view)
        return;
    if (ns == 0)
        m_view->time.showAll(data());
    else
        m_view->time.setLength(ns, data());
    if (m_view->values.isAutomatic())
        m_view->values.setAutomatic(); // another window, another fit: at once
    Q_EMIT viewChanged();
}

void TrendChart::drawBackground(QPainter* painter, const QRectF& rect)
{
    painter->fillRect(rect, color(ColorRole::Panel));
    painter->save();
    painter->setFont(font());
    painter->setRenderHint(QPainter::Antialiasing);
    paintBelowLine(*painter, m_scene);
    painter->restore();
}

void TrendChart::drawForeground(QPainter* painter, const QRectF&)
{
    painter->save();
    painter->setFont(font());
    paintAboveLine(*painter, m_scene);
    if (hasFocus()) {
        painter->setBrush(Qt::NoBrush);
        painter->setPen(QPen(color(ColorRole::Accent), 1));
        painter->drawRect(m_scene.layout.plot.toAlignedRect().adjusted(-1, -1, 0, 0));
    }
    painter->restore();
}

void TrendChart::layOut()
{
    m_scene.layout = TrendLayout::of(viewport()->size(), fontMetrics());
    chart()->setPlotArea(m_scene.layout.plot);
    m_series.setPlotSize(m_scene.layout.plot.size());
}

void TrendChart::applyColors()
{
    m_series.setColors(color(ColorRole::Series), color(ColorRole::Warning));
    viewport()->update();
}

void TrendChart::resizeEvent(QResizeEvent* event)
{
    QChartView::resizeEvent(event);
    layOut();
    Q_EMIT viewChanged();
}

void TrendChart::changeEvent(QEvent* event)
{
    QChartView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        layOut();
        Q_EMIT viewChanged();
    }
}

void TrendChart::focusInEvent(QFocusEvent* event)
{
    QChartView::focusInEvent(event);
    viewport()->update();
}

void TrendChart::focusOutEvent(QFocusEvent* event)
{
    QChartView::focusOutEvent(event);
    viewport()->update();
}

double TrendChart::valueAt(double y) const { return m_scene.scale.valueAt(m_scene.layout.plot.bottom() - y); }

} // namespace lds::ui

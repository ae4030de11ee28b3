// What mouse and keys do to a trend's view: the second half of TrendChart.
#include "trend_chart.h"

#include <algorithm>
#include <cmath>
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

namespace lds::ui {

namespace {

constexpr double zoomPerStep = 0.8; ///< A notch of the wheel or one key press.
constexpr double panPerStep = 0.1;  ///< Of what is shown.
constexpr double wheelNotch = 120;  ///< QWheelEvent::angleDelta() of one.

} // namespace

bool TrendChart::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::Leave)
        setPointer({});
    return QChartView::viewportEvent(event);
}

void TrendChart::setPointer(std::optional<QPointF> pointer)
{
    if (pointer && !m_scene.layout.plot.contains(*pointer))
        pointer.reset();
    if (pointer == m_scene.pointer)
        return;
    m_scene.pointer = pointer;
    Q_EMIT pointerMoved();
}

void TrendChart::wheelEvent(QWheelEvent* event)
{
    event->accept();
    if (!m_view || !m_scene.hasData)
        return;
    const QPointF place = event->position();
    const QPoint delta = event->angleDelta();
    const bool overAxis = place.x() < m_scene.layout.plot.left();
    // With Alt or Shift some platforms turn the wheel's direction sideways.
    const bool sideways = event->modifiers() & Qt::ShiftModifier || std::abs(delta.x()) > std::abs(delta.y());
    const double steps = (sideways && delta.x() != 0 ? delta.x() : delta.y()) / wheelNotch;
    if (event->modifiers() & Qt::ControlModifier || (overAxis && !sideways)) {
        m_view->values.zoomBy(std::pow(zoomPerStep, steps), valueAt(place.y()));
    } else if (sideways) {
        m_view->time.panBy(qint64(-steps * panPerStep * double(m_scene.scale.span.lengthNs())), data());
    } else {
        const double fraction = plotX(place.x()) / m_scene.layout.plot.width();
        m_view->time.zoomBy(std::pow(zoomPerStep, steps), fraction, data());
    }
    Q_EMIT viewChanged();
}

void TrendChart::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_view || !m_scene.hasData)
        return;
    m_drag = event->position().x() < m_scene.layout.plot.left() ? Drag::ValueAxis : Drag::Pan;
    m_dragStart = {event->position(), m_scene.scale.span, m_scene.scale.range};
}

void TrendChart::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF position = event->position();
    if (m_drag != Drag::None)
        dragTo(position);
    else if (position.x() < m_scene.layout.plot.left() && m_scene.hasData)
        viewport()->setCursor(Qt::SizeVerCursor);
    else
        viewport()->unsetCursor();
    setPointer(position);
}

void TrendChart::dragTo(const QPointF& position)
{
    const QPointF way = position - m_dragStart.position;
    if (!m_dragStart.moved && way.manhattanLength() < QApplication::startDragDistance())
        return;
    m_dragStart.moved = true;
    const QRectF plot = m_scene.layout.plot;
    const TrendValueScale::Range& range = m_dragStart.range;
    if (m_drag == Drag::ValueAxis) {
        const double factor = std::pow(2, way.y() / 100); // down: more, up: less
        const double middle = (range.low + range.high) / 2;
        const double half =
            std::clamp(range.span() * factor, TrendValueScale::smallestSpan, TrendValueScale::largestSpan) /
            2;
        m_view->values.setRange({middle - half, middle + half});
    } else {
        viewport()->setCursor(Qt::ClosedHandCursor);
        const auto ns = qint64(way.x() / plot.width() * double(m_dragStart.span.lengthNs()));
        m_view->time.panTo({m_dragStart.span.fromNs - ns, m_dragStart.span.toNs - ns}, data());
        if (!m_view->values.isAutomatic()) {
            const double difference = way.y() / plot.height() * range.span();
            m_view->values.setRange({range.low + difference, range.high + difference});
        }
    }
    Q_EMIT viewChanged();
}

void TrendChart::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_drag = Drag::None;
    viewport()->unsetCursor();
}

void TrendChart::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        follow();
}

void TrendChart::keyPressEvent(QKeyEvent* event)
{
    if (!pressKey(event->key(), event->modifiers()))
        event->ignore();
}

bool TrendChart::pressKey(int key, Qt::KeyboardModifiers modifiers)
{
    if (!m_view)
        return false;
    const TrendSpan stored = data();
    const TrendSpan span = m_view->time.span(stored);
    const double length = double(span.lengthNs());
    const TrendValueScale::Range range = m_view->values.range();
    const bool control = modifiers & Qt::ControlModifier;
    const auto zoom = [&](double factor) {
        if (control)
            m_view->values.zoomBy(factor, (range.low + range.high) / 2);
        else // following goes on when the newest sample stays where it is
            m_view->time.zoomBy(factor, m_view->time.isFollowing() ? 1.0 : 0.5, stored);
    };
    switch (key) {
    case Qt::Key_Left:
        m_view->time.panBy(qint64(-length * panPerStep), stored);
        break;
    case Qt::Key_Right:
        m_view->time.panBy(qint64(length * panPerStep), stored);
        break;
    case Qt::Key_PageUp:
        m_view->time.panBy(-span.lengthNs(), stored);
        break;
    case Qt::Key_PageDown:
        m_view->time.panBy(span.lengthNs(), stored);
        break;
    case Qt::Key_Home:
        m_view->time.panTo({stored.fromNs, stored.fromNs + span.lengthNs()}, stored);
        break;
    case Qt::Key_Up:
        m_view->values.panBy(range.span() * panPerStep);
        break;
    case Qt::Key_Down:
        m_view->values.panBy(-range.span() * panPerStep);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoom(zoomPerStep);
        break; // = is + without Shift on many keyboards
    case Qt::Key_Minus:
        zoom(1 / zoomPerStep);
        break;
    case Qt::Key_End:
        follow();
        return true;
    case Qt::Key_F:
        fit();
        return true;
    case Qt::Key_Space:
        setPaused(!m_view->time.isPaused());
        return true;
    default:
        return false;
    }
    Q_EMIT viewChanged();
    return true;
}

} // namespace lds::ui

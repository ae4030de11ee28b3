#include "key_button.h"

#include <QFontMetrics>
#include <QMouseEvent>
#include <QPainter>

namespace lds::emulator {

namespace {

const QColor keyColor(0x3a, 0x40, 0x49);
const QColor keyDownColor(0x24, 0x28, 0x2e);
const QColor keyEdge(0x5a, 0x63, 0x70);
const QColor latchColor(0xff, 0xb0, 0x2e);
const QColor focusColor(0x6c, 0xb8, 0xff);
const QColor labelColor(0xf2, 0xf6, 0xff);

} // namespace

KeyButton::KeyButton(QWidget* parent)
    : QAbstractButton(parent)
{
    setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard with the panel
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QAbstractButton::pressed, this, &KeyButton::follow);
    connect(this, &QAbstractButton::released, this, &KeyButton::follow);
}

QSize KeyButton::sizeHint() const
{
    const QFontMetrics metrics(font());
    return {metrics.horizontalAdvance(QStringLiteral("ENTER")) + 20, metrics.height() + 14};
}

void KeyButton::unlatch()
{
    m_latched = false;
    follow();
}

void KeyButton::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::RightButton) {
        QAbstractButton::mousePressEvent(event);
        return;
    }
    m_latched = !m_latched;
    follow();
    event->accept();
}

void KeyButton::follow()
{
    update();
    const bool held = isDown() || m_latched;
    if (held == m_held)
        return;
    m_held = held;
    Q_EMIT heldChanged(held);
}

void KeyButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF key = QRectF(rect()).adjusted(2, 2, -2, -2);
    painter.setPen(QPen(m_latched    ? latchColor
                        : hasFocus() ? focusColor
                                     : keyEdge,
                        m_latched || hasFocus() ? 2 : 1));
    painter.setBrush(m_held ? keyDownColor : keyColor);
    painter.drawRoundedRect(key, 6, 6);
    painter.setPen(m_latched ? latchColor : labelColor);
    painter.drawText(key.translated(0, m_held ? 1 : 0), Qt::AlignCenter, text());
}

} // namespace lds::emulator

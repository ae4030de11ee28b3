#include "pill.h"

#include <QPainter>

namespace lds::ui {

namespace {

constexpr int iconSize = 14;
constexpr int padding = 8;

ColorRole inkOf(Pill::Kind kind)
{
    switch (kind) {
    case Pill::Kind::Good:
        return ColorRole::Go;
    case Pill::Kind::Warning:
        return ColorRole::Warning;
    case Pill::Kind::Bad:
        return ColorRole::Error;
    case Pill::Kind::Quiet:
        break;
    }
    return ColorRole::Muted;
}

QString iconOf(Pill::Kind kind)
{
    switch (kind) {
    case Pill::Kind::Good:
        return QStringLiteral("state-ok");
    case Pill::Kind::Warning:
        return QStringLiteral("state-warning");
    case Pill::Kind::Bad:
        return QStringLiteral("state-error");
    case Pill::Kind::Quiet:
        break;
    }
    return QStringLiteral("state-offline");
}

} // namespace

Pill::Pill(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void Pill::setState(Kind kind, const QString& text)
{
    if (kind == m_kind && text == m_text)
        return;
    m_kind = kind;
    m_text = text;
    setAccessibleName(text);
    updateGeometry();
    update();
}

QFont Pill::textFont() const
{
    QFont small = font();
    small.setPointSizeF(font().pointSizeF() * 0.87);
    small.setWeight(QFont::DemiBold);
    return small;
}

QSize Pill::sizeHint() const
{
    const QFontMetrics metrics(textFont());
    return {2 * padding + iconSize + 5 + metrics.horizontalAdvance(m_text), qMax(20, metrics.height() + 4)};
}

void Pill::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor ink = color(inkOf(m_kind));
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.setPen(m_kind == Kind::Warning ? QPen(Qt::NoPen)
                                           : QPen(m_kind == Kind::Quiet ? color(ColorRole::Line) : ink));
    painter.setBrush(m_kind == Kind::Warning ? QBrush(color(ColorRole::Edit)) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(frame, frame.height() / 2, frame.height() / 2);
    const QRect icon(padding, (height() - iconSize) / 2, iconSize, iconSize);
    Theme::instance().icon(iconOf(m_kind), inkOf(m_kind)).paint(&painter, icon);
    painter.setPen(ink);
    painter.setFont(textFont());
    painter.drawText(rect().adjusted(icon.right() + 6, 0, -padding / 2, 0), Qt::AlignVCenter | Qt::AlignLeft,
                     m_text);
}

} // namespace lds::ui

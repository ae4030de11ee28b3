#include "editor_message.h"

#include "theme.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>

namespace lds::ui {

namespace {

constexpr int widest = 340;
constexpr int iconSize = 16;

ColorRole roleOf(EditorMessage::Kind kind)
{
    switch (kind) {
    case EditorMessage::Kind::Note:
        return ColorRole::Accent;
    case EditorMessage::Kind::Warning:
        return ColorRole::Warning;
    case EditorMessage::Kind::Error:
        return ColorRole::Error;
    }
    return ColorRole::Text;
}

QString iconOf(EditorMessage::Kind kind)
{
    switch (kind) {
    case EditorMessage::Kind::Note:
        return QStringLiteral("info");
    case EditorMessage::Kind::Warning:
        return QStringLiteral("state-warning");
    case EditorMessage::Kind::Error:
        return QStringLiteral("state-error");
    }
    return {};
}

} // namespace

EditorMessage::EditorMessage(QWidget& editor)
    : QFrame(editor.parentWidget())
    , m_editor(editor)
    , m_icon(new QLabel(this))
    , m_label(new QLabel(this))
{
    setObjectName(QStringLiteral("editorMessage"));
    m_label->setWordWrap(true);
    m_label->setTextFormat(Qt::PlainText);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(2 * Theme::unit, Theme::unit, 2 * Theme::unit, Theme::unit);
    layout->setSpacing(2 * Theme::unit);
    layout->addWidget(m_icon, 0, Qt::AlignTop);
    layout->addWidget(m_label, 1);
    hide();
    editor.installEventFilter(this);
    connect(&editor, &QObject::destroyed, this, &QObject::deleteLater);
}

void EditorMessage::setMessage(Kind kind, const QString& text)
{
    if (text == m_text && kind == m_kind && isVisible() == !text.isEmpty())
        return;
    m_text = text;
    m_kind = kind;
    m_label->setText(text);
    m_icon->setPixmap(Theme::instance().icon(iconOf(kind), roleOf(kind)).pixmap(iconSize, iconSize));
    setVisible(!text.isEmpty() && m_editor.isVisible());
    // The editor keeps the focus: its description is what a screen reader says beside the text.
    m_editor.setAccessibleDescription(text);
    setAccessibleName(text);
    if (isVisible()) {
        QAccessibleEvent alert(this, QAccessible::Alert);
        QAccessible::updateAccessibility(&alert);
    }
    place();
}

void EditorMessage::place()
{
    const QWidget* area = parentWidget();
    if (!area || m_text.isEmpty())
        return;
    const int width = qMin(widest, area->width());
    const int height =
        layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
    const QRect editor = m_editor.geometry();
    const int x = qBound(0, editor.right() + 1 - width, qMax(0, area->width() - width));
    const bool fitsBelow = editor.bottom() + 2 + height <= area->height();
    const int y = fitsBelow ? editor.bottom() + 2 : qMax(0, editor.top() - 2 - height);
    setGeometry(x, y, width, height);
    raise();
}

bool EditorMessage::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_editor) {
        switch (event->type()) {
        case QEvent::Move:
        case QEvent::Resize:
            place();
            break;
        case QEvent::Show:
            setVisible(!m_text.isEmpty());
            place();
            break;
        case QEvent::Hide:
            hide();
            break;
        default:
            break;
        }
    }
    return QFrame::eventFilter(watched, event);
}

void EditorMessage::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(color(roleOf(m_kind)), 1));
    painter.setBrush(color(ColorRole::Panel));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

} // namespace lds::ui

#include "action_button.h"

#include <QAction>

namespace lds::ui {

ActionButton::ActionButton(QAction* action, Look look, QWidget* parent)
    : QPushButton(parent)
    , m_action(action)
{
    setObjectName(QStringLiteral("button.") + action->objectName());
    if (look == Look::Primary)
        setProperty("primary", true);
    else if (look == Look::Quiet)
        setProperty("quiet", true);
    connect(action, &QAction::changed, this, &ActionButton::follow);
    connect(this, &QPushButton::clicked, action, &QAction::trigger);
    follow();
}

void ActionButton::setCompact(bool compact)
{
    if (m_compact == compact)
        return;
    m_compact = compact;
    follow();
}

int ActionButton::fullWidth() const
{
    constexpr int frame = 24; // the style sheet's padding and border on both sides
    return frame + (m_action ? fontMetrics().horizontalAdvance(m_action->iconText()) : 0);
}

void ActionButton::follow()
{
    if (!m_action)
        return;
    const QString text = m_action->iconText();
    setText(m_compact ? QString() : text);
    setIcon(m_compact || m_action->property("iconOnButton").toBool() ? m_action->icon() : QIcon());
    setEnabled(m_action->isEnabled());
    setVisible(m_action->isVisible());
    setAccessibleName(text);
    const QString tip = m_action->toolTip().isEmpty() ? text : m_action->toolTip();
    const QString keys = m_action->shortcut().toString(QKeySequence::NativeText);
    setToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys));
    setAccessibleDescription(m_action->toolTip());
}

} // namespace lds::ui

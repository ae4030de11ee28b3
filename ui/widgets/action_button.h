#pragma once

#include <QPointer>
#include <QPushButton>

class QAction;

namespace lds::ui {

/// A push button that stands for an action: its text, icon, tip with shortcut, and whether it can be
/// used follow the action's.
class ActionButton final : public QPushButton {
    Q_OBJECT

public:
    enum class Look { Quiet, Outline, Primary };

    ActionButton(QAction* action, Look look, QWidget* parent = nullptr);
    /// Only the icon, when there is little room; the text stays the accessible name.
    void setCompact(bool compact);
    /// What it asks for with its text, whether or not it is compact now.
    int fullWidth() const;

private:
    void follow();

    QPointer<QAction> m_action;
    bool m_compact = false;
};

} // namespace lds::ui

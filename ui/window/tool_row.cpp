#include "tool_row.h"

#include "action_button.h"
#include "pill.h"
#include "sentences.h"
#include "theme.h"
#include "window_actions.h"

#include <QAction>
#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>

namespace lds::ui {

namespace {

constexpr int compactWidth = 38; ///< An icon in the style sheet's frame.

Pill::Kind kindOf(sensor::Saved saved)
{
    switch (saved) {
    case sensor::Saved::Saved:
        return Pill::Kind::Good;
    case sensor::Saved::NotSaved:
        return Pill::Kind::Warning;
    case sensor::Saved::Unknown:
        break;
    }
    return Pill::Kind::Quiet;
}

QString tipOf(sensor::Saved saved)
{
    switch (saved) {
    case sensor::Saved::Saved:
        return ToolRow::tr("The sensor's memory holds what it works with.");
    case sensor::Saved::NotSaved:
        return ToolRow::tr("Something was written since the last saving. It is gone when the power goes.");
    case sensor::Saved::Unknown:
        break;
    }
    return ToolRow::tr(
        "The sensor does not tell whether its memory holds what it works with. Saving makes it "
        "certain.");
}

} // namespace

ToolRow::ToolRow(const WindowActions& actions, QWidget* parent)
    : QWidget(parent)
    , m_saved(new Pill(this))
{
    using Look = ActionButton::Look;
    setObjectName(QStringLiteral("toolRow"));
    setAttribute(Qt::WA_StyledBackground);
    m_saved->setObjectName(QStringLiteral("savedPill"));
    m_saved->hide();
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 12, 6);
    row->setSpacing(4);
    const auto add = [&](QAction* action, Look look) {
        auto* button = new ActionButton(action, look, this);
        row->addWidget(button);
        return button;
    };
    add(actions.connectSensor, Look::Outline);
    auto* readAll = add(actions.readAll, Look::Quiet);
    add(actions.review, Look::Primary);
    auto* undo = add(actions.undo, Look::Quiet);
    auto* redo = add(actions.redo, Look::Quiet);
    auto* line = new QFrame(this);
    line->setProperty("separator", true);
    line->setFixedSize(1, 20);
    row->addSpacing(4);
    row->addWidget(line);
    row->addSpacing(4);
    auto* zero = add(actions.zeroSet, Look::Quiet);
    auto* reset = add(actions.resetValue, Look::Quiet);
    auto* laser = add(actions.laser, Look::Quiet);
    row->addStretch(1);
    row->addWidget(m_saved);
    row->addSpacing(4);
    add(actions.saveInSensor, Look::Outline);
    m_shrinking = {redo, undo, reset, zero, readAll, laser};
}

void ToolRow::showSaved(const sensor::SensorSession* session)
{
    m_saved->setVisible(session != nullptr);
    if (session) {
        m_saved->setState(kindOf(session->saved()), savedWord(session->saved()));
        m_saved->setToolTip(tipOf(session->saved()));
    }
    fit();
}

int ToolRow::widthOfTheRest() const
{
    int width = layout()->sizeHint().width();
    for (const ActionButton* button : m_shrinking)
        width -= button->sizeHint().width();
    return width;
}

QSize ToolRow::minimumSizeHint() const
{
    return {widthOfTheRest() + int(m_shrinking.size()) * compactWidth, sizeHint().height()};
}

void ToolRow::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fit();
}

bool ToolRow::event(QEvent* event)
{
    const bool handled = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest)
        fit(); // a text has changed
    return handled;
}

void ToolRow::fit()
{
    int needed = widthOfTheRest();
    for (const ActionButton* button : m_shrinking)
        needed += button->fullWidth();
    for (ActionButton* button : m_shrinking) {
        const bool compact = needed > width();
        if (compact)
            needed -= button->fullWidth() - compactWidth;
        button->setCompact(compact);
    }
}

} // namespace lds::ui

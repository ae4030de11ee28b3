#include "empty_page.h"

#include "action_button.h"
#include "window_actions.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace lds::ui {

EmptyPage::EmptyPage(const WindowActions& actions, QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("emptyPage"));
    auto* title = new QLabel(tr("No sensor yet"), this);
    title->setProperty("title", true);
    auto* text =
        new QLabel(tr("Connect an HL-G2 by the address its display shows in menu 71. With no sensor at "
                      "hand, a virtual one does the same on this computer."),
                   this);
    text->setWordWrap(true);
    text->setProperty("muted", true);
    text->setFixedWidth(440);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    // The one blue button of the window is grey while there is nothing to apply, so this is the next step.
    buttons->addWidget(new ActionButton(actions.connectSensor, ActionButton::Look::Primary, this));
    buttons->addWidget(new ActionButton(actions.demo, ActionButton::Look::Outline, this));
    buttons->addStretch(1);

    auto* column = new QVBoxLayout;
    column->setSpacing(12);
    column->addWidget(title);
    column->addWidget(text);
    column->addLayout(buttons);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addLayout(column);
    row->addStretch(1);
    auto* page = new QVBoxLayout(this);
    page->addStretch(2);
    page->addLayout(row);
    page->addStretch(3);
}

} // namespace lds::ui

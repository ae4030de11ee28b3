#include "item_delegate.h"

#include "choice_editor.h"
#include "number_editor.h"
#include "octets_editor.h"
#include "row_painter.h"
#include "settings_model.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>

namespace lds::ui {

namespace {

/// Also across windows: the list of a combo box is a window of its own, and still the combo box's.
bool belongsTo(const QWidget* widget, const QWidget* editor)
{
    while (widget && widget != editor)
        widget = widget->parentWidget();
    return widget != nullptr;
}

} // namespace

ItemDelegate::ItemDelegate(SettingsModel& model, QObject* parent)
    : QStyledItemDelegate(parent)
    , m_model(model)
{}

void ItemDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const
{
    row_painter::paintCell(painter, option, index);
}

QSize ItemDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const int height = qMax(row_painter::height, option.fontMetrics.height() + 6);
    return {row_painter::contentWidth(option, index), height};
}

QWidget* ItemDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                    const QModelIndex& index) const
{
    const auto* row = index.data(SettingsModel::RowRole).value<const SettingRow*>();
    if (!row || !m_model.session())
        return nullptr;
    QWidget* editor = nullptr;
    auto& session = *m_model.session();
    auto* self = const_cast<ItemDelegate*>(this); // the signals of an editor's life are not its state
    if (row->shape == SettingRow::Shape::Octets) {
        editor = new OctetsEditor(*row, session, parent);
    } else if (row->first()->kind == catalog::Kind::Choice) {
        auto* choice = new ChoiceEditor(*row, session, parent);
        connect(choice, &ChoiceEditor::chosen, self, [self, choice] { self->finish(choice); });
        editor = choice;
    } else {
        editor = new NumberEditor(*row, session, parent);
    }
    Q_EMIT self->editorOpened(editor);
    return editor;
}

// The editor loads itself once, when it is made. The view calls this again whenever the value in the
// sensor changes; what a person is typing must survive that.
void ItemDelegate::setEditorData(QWidget* widget, const QModelIndex&) const
{
    RowEditor* editor = rowEditor(widget);
    if (!editor || widget->property("loaded").toBool())
        return;
    widget->setProperty("loaded", true);
    if (const auto wrong = m_model.wrongInput(editor->row()); !wrong.text.isEmpty())
        editor->restore(wrong.text);
    if (auto* number = qobject_cast<QAbstractSpinBox*>(widget))
        number->selectAll(); // what is typed takes the place of what was there
}

void ItemDelegate::setModelData(QWidget* widget, QAbstractItemModel*, const QModelIndex&) const
{
    RowEditor* editor = rowEditor(widget);
    if (!editor || !editor->isAcceptable())
        return;
    editor->commit();
    m_model.keepWrongInput(editor->row(), {});
}

void ItemDelegate::updateEditorGeometry(QWidget* widget, const QStyleOptionViewItem& option,
                                        const QModelIndex&) const
{
    QRect rect = option.rect;
    const int wanted = qMax(rect.width(), widget->sizeHint().width());
    const int room = widget->parentWidget()->width();
    rect.setWidth(qMin(wanted, room));
    // The value in the sensor stands to the left and stays in sight; an address grows over the unit.
    if (rect.right() >= room)
        rect.moveRight(room - 1);
    widget->setGeometry(rect);
}

void ItemDelegate::destroyEditor(QWidget* widget, const QModelIndex&) const
{
    if (const RowEditor* editor = rowEditor(widget); editor && !editor->isAbandoned())
        keepWrongInput(*editor);
    widget->deleteLater();
    Q_EMIT const_cast<ItemDelegate*>(this)->editorClosed(widget);
}

void ItemDelegate::keepWrongInput(const RowEditor& editor) const
{
    if (!editor.isAcceptable())
        m_model.keepWrongInput(editor.row(), {editor.text(), editor.error()});
}

bool ItemDelegate::finish(QWidget* widget)
{
    RowEditor* editor = rowEditor(widget);
    if (!editor)
        return true;
    if (!editor->isAcceptable()) {
        editor->insist();
        return false;
    }
    Q_EMIT commitData(widget);
    Q_EMIT closeEditor(widget, NoHint);
    return true;
}

bool ItemDelegate::keyPressed(QWidget* widget, RowEditor& editor, const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (finish(widget))
            Q_EMIT entered();
        return true;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        if (finish(widget))
            Q_EMIT tabbed(event.key() == Qt::Key_Tab);
        return true;
    case Qt::Key_Escape:
        editor.abandon();
        m_model.keepWrongInput(editor.row(), {});
        Q_EMIT closeEditor(widget, RevertModelCache);
        return true;
    default:
        return false;
    }
}

bool ItemDelegate::eventFilter(QObject* watched, QEvent* event)
{
    auto* widget = qobject_cast<QWidget*>(watched);
    RowEditor* editor = widget ? rowEditor(widget) : nullptr;
    if (!editor)
        return QStyledItemDelegate::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress)
        return keyPressed(widget, *editor, *static_cast<QKeyEvent*>(event));
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept(); // Esc is the editor's, whatever the window makes of it
        return true;
    }
    if (event->type() == QEvent::FocusOut) {
        const auto reason = static_cast<QFocusEvent*>(event)->reason();
        // Another window, a menu or the list of choices: the person comes back to the editor.
        const bool comesBack = reason == Qt::ActiveWindowFocusReason || reason == Qt::PopupFocusReason ||
                               reason == Qt::MenuBarFocusReason;
        if (comesBack || belongsTo(QApplication::focusWidget(), widget))
            return false;
        if (editor->isAcceptable()) {
            Q_EMIT commitData(widget);
            Q_EMIT closeEditor(widget, NoHint);
        } else {
            keepWrongInput(*editor); // it stays open and goes on saying what is wrong
        }
    }
    return false;
}

bool ItemDelegate::editorEvent(QEvent* event, QAbstractItemModel*, const QStyleOptionViewItem& option,
                               const QModelIndex& index)
{
    if (event->type() != QEvent::MouseButtonRelease)
        return false;
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (mouse->button() != Qt::LeftButton ||
        !row_painter::buttonRect(option, index).contains(mouse->position().toPoint()))
        return false;
    Q_EMIT orderRequested(index);
    return true;
}

} // namespace lds::ui

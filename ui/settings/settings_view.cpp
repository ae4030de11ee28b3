#include "settings_view.h"

#include "item_delegate.h"
#include "row_editor.h"
#include "row_painter.h"
#include "settings_model.h"
#include "theme.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>

namespace lds::ui {

namespace {

constexpr int narrowestItemColumn = 144;
constexpr int comfortableItemColumn = 152;
constexpr int narrowestValueColumn = 108;
constexpr int widestValueColumn = 150;
constexpr int narrowestRangeColumn = 130;
constexpr int widestRangeColumn = 240;
constexpr int narrowestDefaultColumn = 100;
constexpr int widestDefaultColumn = 104;

/// At most `most`, but never less than `least`, even where the two contradict each other.
int within(int least, int value, int most) { return qMax(least, qMin(value, most)); }

QModelIndex newValueOf(const QModelIndex& index) { return index.siblingAtColumn(SettingsModel::NewValue); }

} // namespace

SettingsView::SettingsView(QWidget* parent)
    : QTreeView(parent)
{
    setObjectName(QStringLiteral("settingsTree"));
    setAccessibleName(tr("Settings by menu number"));
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed | SelectedClicked);
    setExpandsOnDoubleClick(true);
    setIndentation(12);
    viewport()->setAttribute(Qt::WA_Hover);
    setTabKeyNavigation(false);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setHorizontalScrollMode(ScrollPerPixel);
    setVerticalScrollMode(ScrollPerPixel);
    setFrameShape(QFrame::NoFrame);
    header()->setSectionsMovable(false);
    header()->setStretchLastSection(false);
    header()->setHighlightSections(false);
    header()->setMinimumSectionSize(40);
    connect(&Theme::instance(), &Theme::changed, viewport(), qOverload<>(&QWidget::update));
}

SettingsView::~SettingsView() = default;

void SettingsView::setDelegate(ItemDelegate* delegate)
{
    m_delegate = delegate;
    setItemDelegate(delegate);
    connect(delegate, &ItemDelegate::orderRequested, this, &SettingsView::orderRequested);
    connect(delegate, &ItemDelegate::entered, this, [this] {
        const QModelIndex next = nextRow(currentIndex(), true, false);
        if (next.isValid())
            setCurrentIndex(next);
        setFocus();
    });
    connect(delegate, &ItemDelegate::tabbed, this, [this](bool forward) {
        const QModelIndex next = nextRow(currentIndex(), forward, true);
        if (next.isValid()) {
            setCurrentIndex(next);
            edit(newValueOf(next), AnyKeyPressed, nullptr); // as typing does: no list pops up
        }
    });
    // The base class's state does not do: it forgets an editor that stays open without the focus.
    connect(delegate, &ItemDelegate::editorOpened, this, [this](QWidget* editor) { m_editor = editor; });
    connect(delegate, &ItemDelegate::editorClosed, this, [this](const QWidget* editor) {
        if (editor == m_editor)
            m_editor = nullptr;
    });
    connect(
        delegate, &ItemDelegate::editorClosed, this,
        [this] {
            if (!m_editor)
                Q_EMIT editingChanged({});
        },
        Qt::QueuedConnection); // rows may go then, which must not happen while an editor is being closed
}

QModelIndex SettingsView::nextRow(const QModelIndex& from, bool forward, bool editableOnly) const
{
    QModelIndex index = from;
    do {
        index = forward ? indexBelow(index) : indexAbove(index);
        const QModelIndex cell = newValueOf(index);
        const bool isHeading =
            index.isValid() && model()->hasChildren(index.siblingAtColumn(SettingsModel::Menu));
        if (index.isValid() && !isHeading &&
            (!editableOnly || model()->flags(cell).testFlag(Qt::ItemIsEditable)))
            return index.siblingAtColumn(from.column());
    } while (index.isValid());
    return {};
}

bool SettingsView::isButtonRow(const QModelIndex& index) const
{
    return index.isValid() && !newValueOf(index).data(SettingsModel::ButtonRole).toString().isEmpty();
}

bool SettingsView::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event)
{
    if (trigger == NoEditTriggers || !index.isValid())
        return QTreeView::edit(index, trigger, event);
    if (RowEditor* open = rowEditor(m_editor); open && !open->isAcceptable()) {
        open->insist(); // one thing after the other: the wrong text first
        return true;
    }
    if (isButtonRow(index) && (trigger == DoubleClicked || trigger == EditKeyPressed)) {
        Q_EMIT orderRequested(newValueOf(index));
        return true;
    }
    if (trigger == SelectedClicked && index.column() != SettingsModel::NewValue)
        return false;
    const QModelIndex cell = newValueOf(index);
    const bool isHeading = model()->hasChildren(index.siblingAtColumn(SettingsModel::Menu));
    if (!isHeading && !model()->flags(cell).testFlag(Qt::ItemIsEditable)) {
        Q_EMIT editRefused(cell);
        return true; // not on to the base class, which would take the key for a search
    }
    if (!QTreeView::edit(cell, trigger, event))
        return false;
    if (m_editor) {
        Q_EMIT editingChanged(cell);
        auto* choices = qobject_cast<QComboBox*>(m_editor);
        if (choices && trigger != AnyKeyPressed)
            choices->showPopup();
    }
    return true;
}

void SettingsView::editRow(const QModelIndex& index)
{
    setCurrentIndex(index);
    edit(index, EditKeyPressed, nullptr);
}

bool SettingsView::finishEditing() { return !m_editor || m_delegate->finish(m_editor); }

void SettingsView::releaseEditing()
{
    if (!m_editor)
        return;
    const RowEditor* editor = rowEditor(m_editor);
    if (editor && editor->isAcceptable()) {
        m_delegate->finish(m_editor);
        return;
    }
    m_releasing = true;
    closeEditor(m_editor, QAbstractItemDelegate::NoHint); // the delegate keeps the text in the model
    m_releasing = false;
}

void SettingsView::closeEditor(QWidget* widget, QAbstractItemDelegate::EndEditHint hint)
{
    const RowEditor* editor = rowEditor(widget);
    if (editor && !m_releasing && !editor->isAbandoned() && !editor->isAcceptable())
        return;
    const QWidget* focus = QApplication::focusWidget();
    const bool hadFocus = focus && (focus == widget || widget->isAncestorOf(focus));
    QTreeView::closeEditor(widget, hint);
    if (widget == m_editor)
        m_editor = nullptr;
    if (hadFocus)
        setFocus(); // the base class looks at the editor itself only, not at the fields in it
}

void SettingsView::pasteIntoRow()
{
    editRow(currentIndex());
    if (!m_editor || qobject_cast<QComboBox*>(m_editor))
        return;
    QWidget* target = m_editor->focusProxy() ? m_editor->focusProxy() : m_editor.data();
    QKeyEvent paste(QEvent::KeyPress, Qt::Key_V, Qt::ControlModifier);
    QApplication::sendEvent(target, &paste);
}

void SettingsView::keyPressEvent(QKeyEvent* event)
{
    const QModelIndex current = currentIndex();
    if (event->matches(QKeySequence::Copy)) {
        Q_EMIT copyRequested();
        return;
    }
    if (event->matches(QKeySequence::Paste) && current.isValid()) {
        pasteIntoRow();
        return;
    }
    switch (event->key()) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        Q_EMIT revertRequested(current);
        return;
    case Qt::Key_F1:
        Q_EMIT detailsRequested();
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        if (!current.isValid())
            break;
        if (model()->hasChildren(current.siblingAtColumn(0)))
            setExpanded(current.siblingAtColumn(0), !isExpanded(current.siblingAtColumn(0)));
        else
            edit(current, EditKeyPressed, nullptr);
        return;
    default:
        break;
    }
    QTreeView::keyPressEvent(event);
}

void SettingsView::drawRow(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const
{
    row_painter::RowLook look;
    look.selected = selectionModel()->isRowSelected(index.row(), index.parent());
    look.current = hasFocus() && currentIndex().siblingAtColumn(0) == index.siblingAtColumn(0);
    const QRect row(0, option.rect.y(), viewport()->width(), option.rect.height());
    const QPoint pointer = viewport()->mapFromGlobal(QCursor::pos());
    look.hovered = viewport()->underMouse() && row.contains(pointer);
    row_painter::paintRow(painter, row, index, look);
    for (int column = 0; column < SettingsModel::ColumnCount; ++column) {
        if (isColumnHidden(column))
            continue;
        const QModelIndex cell = index.siblingAtColumn(column);
        QStyleOptionViewItem cellOption = option;
        cellOption.rect = paintedRect(cell);
        cellOption.state.setFlag(QStyle::State_MouseOver, look.hovered && cellOption.rect.contains(pointer));
        itemDelegate()->paint(painter, cellOption, cell);
    }
    if (model()->hasChildren(index.siblingAtColumn(0)))
        drawArrow(painter, index.siblingAtColumn(0));
    row_painter::paintRowFrame(painter, row, look);
}

QRect SettingsView::paintedRect(const QModelIndex& cell) const
{
    QRect rect = visualRect(cell);
    const auto* row = cell.data(SettingsModel::RowRole).value<const SettingRow*>();
    if (cell.column() == SettingsModel::Item) {
        if (!row->menu)
            rect.setLeft(visualRect(cell.siblingAtColumn(SettingsModel::Menu)).left() - Theme::unit);
        if (row->isHeading())
            rect.setRight(visualRect(cell.siblingAtColumn(SettingsModel::Unit)).right());
    }
    // The reason why there is no value needs the room of two columns, which are both empty then.
    const auto states = SettingsModel::RowStates(cell.data(SettingsModel::StateRole).toInt());
    if (cell.column() == SettingsModel::InSensor && states.testFlag(SettingsModel::Missing) &&
        !isButtonRow(cell))
        rect.setRight(visualRect(newValueOf(cell)).right());
    return rect;
}

void SettingsView::drawArrow(QPainter* painter, const QModelIndex& index) const
{
    const QRect cell = visualRect(index);
    constexpr int size = 12;
    const QRect arrow(cell.left() - indentation() + 2, cell.center().y() - size / 2 + 1, size, size);
    const QString name = isExpanded(index) ? QStringLiteral("chevron-down") : QStringLiteral("chevron-right");
    Theme::instance().icon(name).paint(painter, arrow);
}

void SettingsView::setEmptyText(const QString& text)
{
    m_emptyText = text;
    viewport()->update();
}

void SettingsView::paintEvent(QPaintEvent* event)
{
    QTreeView::paintEvent(event);
    if (!model() || model()->rowCount() > 0 || m_emptyText.isEmpty())
        return;
    QPainter painter(viewport());
    painter.setPen(color(ColorRole::Muted));
    painter.drawText(viewport()->rect().adjusted(24, 24, -24, -24),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, m_emptyText);
}

void SettingsView::measureColumns(bool afresh)
{
    if (afresh)
        m_widths.clear();
    if (!model() || model()->columnCount() < SettingsModel::ColumnCount)
        return;
    m_widths.resize(SettingsModel::ColumnCount);
    const QFontMetrics metrics(header()->font());
    for (int column = 0; column < SettingsModel::ColumnCount; ++column) {
        const QString title = model()->headerData(column, Qt::Horizontal).toString();
        m_widths[column] =
            qMax(m_widths[column], metrics.horizontalAdvance(title) + 5 * row_painter::padding / 2);
    }
    measureRows({}, 1);
    fitColumns();
}

void SettingsView::measureRows(const QModelIndex& parent, int depth)
{
    QStyleOptionViewItem option;
    initViewItemOption(&option);
    for (int row = 0; row < model()->rowCount(parent); ++row) {
        const QModelIndex first = model()->index(row, SettingsModel::Menu, parent);
        for (int column = 0; column < SettingsModel::ColumnCount; ++column) {
            const int indent = column == SettingsModel::Menu ? depth * indentation() : 0;
            const QSize size = itemDelegate()->sizeHint(option, first.siblingAtColumn(column));
            m_widths[column] = qMax(m_widths[column], size.width() + indent);
        }
        measureRows(first, depth + 1);
    }
}

void SettingsView::fitColumns()
{
    if (m_widths.isEmpty())
        return;
    const int menu = m_widths[SettingsModel::Menu];
    const int unit = m_widths[SettingsModel::Unit];
    int held = qMin(m_widths[SettingsModel::InSensor], widestValueColumn);
    int wanted = qMin(m_widths[SettingsModel::NewValue], widestValueColumn);
    const int room = viewport()->width() - menu - unit;
    // The values come first, then the range, then the default; the item's name takes what is left.
    if (room < narrowestItemColumn + held + wanted) {
        held = within(narrowestValueColumn, (room - narrowestItemColumn) / 2, held);
        wanted = within(narrowestValueColumn, room - narrowestItemColumn - held, wanted);
    }
    const int spare = room - held - wanted;
    const bool showRange = spare >= narrowestItemColumn + narrowestRangeColumn;
    const bool showDefault = spare >= narrowestItemColumn + narrowestRangeColumn + narrowestDefaultColumn;
    const int standard =
        within(narrowestDefaultColumn, m_widths[SettingsModel::Default], widestDefaultColumn);
    const int range =
        within(narrowestRangeColumn, m_widths[SettingsModel::Range],
               qMin(widestRangeColumn, spare - comfortableItemColumn - (showDefault ? standard : 0)));
    QHeaderView* head = header();
    head->setSectionResizeMode(QHeaderView::Interactive);
    head->resizeSection(SettingsModel::Menu, menu);
    head->resizeSection(SettingsModel::InSensor, held);
    head->resizeSection(SettingsModel::NewValue, wanted);
    head->resizeSection(SettingsModel::Unit, unit);
    setColumnHidden(SettingsModel::Range, !showRange);
    setColumnHidden(SettingsModel::Default, !showDefault);
    head->resizeSection(SettingsModel::Range, range);
    head->resizeSection(SettingsModel::Default, standard);
    head->setSectionResizeMode(SettingsModel::Item, QHeaderView::Stretch);
}

void SettingsView::resizeEvent(QResizeEvent* event)
{
    QTreeView::resizeEvent(event);
    fitColumns();
}

} // namespace lds::ui

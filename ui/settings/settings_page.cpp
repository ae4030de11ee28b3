#include "settings_page.h"

#include "bank_buttons.h"
#include "details_pane.h"
#include "item_delegate.h"
#include "row_menus.h"
#include "settings_filter.h"
#include "settings_model.h"
#include "settings_view.h"
#include "theme.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QShortcut>
#include <QSplitter>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

namespace lds::ui {

using catalog::ItemId;
using sensor::SensorSession;

namespace {
constexpr int detailsWidth = 280;
constexpr int narrowDetailsWidth = 220;
constexpr int narrowPage = 900; ///< Below it the details pane is slimmer.
} // namespace

struct SettingsPage::Private {
    explicit Private(SettingsPage& owner)
        : page(owner)
    {}

    SettingsPage& page;
    SettingsModel& model = *new SettingsModel(&page);
    SettingsFilter filter{model};
    ItemDelegate delegate{model, nullptr};
    RowMenus menus{model};
    QLineEdit* filterBox = nullptr;
    QCheckBox* changedOnly = nullptr;
    BankButtons* banks = nullptr;
    QToolButton* detailsButton = nullptr;
    QLabel* staleNote = nullptr;
    QSplitter* splitter = nullptr;
    SettingsView* view = nullptr;
    DetailsPane* details = nullptr;

    void build();
    QWidget* buildBar();
    void connectAll();
    void filterChanged();
    void refreshEmptyText();
    QModelIndex firstItem() const; ///< The first row that is no heading.
    void explainRefusal(const QModelIndex& index);
    void refreshStaleNote();
    void select(const QModelIndex& sourceIndex);
    void showDetails(bool visible);
    const SettingRow* currentRow() const { return model.row(filter.mapToSource(view->currentIndex())); }
    void popUpOrders(const QModelIndex& proxyIndex);
    void popUpContext(const QPoint& position);
};

SettingsPage::SettingsPage(QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(*this))
{
    d->build();
    d->connectAll();
    d->refreshEmptyText();
    d->refreshStaleNote();
}

SettingsPage::~SettingsPage()
{
    delete d->splitter; // view and pane look at the model, which goes with d
}

void SettingsPage::Private::build()
{
    page.setProperty("card", true);
    page.setAttribute(Qt::WA_StyledBackground);
    auto* layout = new QVBoxLayout(&page);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    layout->addWidget(buildBar());
    auto* line = new QFrame(&page);
    line->setFixedHeight(1);
    line->setAutoFillBackground(true);
    line->setForegroundRole(QPalette::Mid);
    line->setBackgroundRole(QPalette::Mid);
    layout->addWidget(line);
    staleNote = new QLabel(&page);
    staleNote->setObjectName(QStringLiteral("staleNote"));
    staleNote->setContentsMargins(3 * Theme::unit, Theme::unit, 3 * Theme::unit, Theme::unit);
    staleNote->setWordWrap(true);
    layout->addWidget(staleNote);
    splitter = new QSplitter(Qt::Horizontal, &page);
    splitter->setHandleWidth(1);
    splitter->setChildrenCollapsible(true);
    view = new SettingsView(splitter);
    view->setModel(&filter);
    view->setDelegate(&delegate);
    details = new DetailsPane(model, splitter);
    splitter->addWidget(view);
    splitter->addWidget(details);
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 0);
    splitter->setCollapsible(0, false);
    layout->addWidget(splitter, 1);
}

QWidget* SettingsPage::Private::buildBar()
{
    auto* bar = new QWidget(&page);
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(10, 6, 10, 6);
    layout->setSpacing(2 * Theme::unit);
    filterBox = new QLineEdit(bar);
    filterBox->setObjectName(QStringLiteral("filter"));
    filterBox->setPlaceholderText(tr("Filter by number, name or value"));
    filterBox->setAccessibleName(tr("Filter the settings"));
    filterBox->setAccessibleDescription(
        tr("Number, name, value or a word of the help text; all words must match"));
    filterBox->setClearButtonEnabled(true);
    filterBox->setMaximumWidth(280);
    filterBox->setMinimumWidth(140);
    changedOnly = new QCheckBox(tr("Changed only"), bar);
    changedOnly->setObjectName(QStringLiteral("changedOnly"));
    banks = new BankButtons(bar);
    detailsButton = new QToolButton(bar);
    detailsButton->setObjectName(QStringLiteral("detailsButton"));
    detailsButton->setText(tr("Details"));
    detailsButton->setCheckable(true);
    detailsButton->setChecked(true);
    detailsButton->setToolTip(tr("Show or hide the details of the chosen item (F1)"));
    layout->addWidget(filterBox, 3);
    layout->addWidget(changedOnly);
    layout->addStretch(1);
    layout->addWidget(banks);
    layout->addSpacing(Theme::unit);
    layout->addWidget(detailsButton);
    return bar;
}

void SettingsPage::Private::connectAll()
{
    connect(filterBox, &QLineEdit::textChanged, &page, [this] { filterChanged(); });
    connect(filterBox, &QLineEdit::returnPressed, &page, [this] { view->setFocus(); });
    connect(changedOnly, &QCheckBox::toggled, &page, [this] { filterChanged(); });
    connect(banks, &BankButtons::requested, &page,
            [this](catalog::Value bank) { Q_EMIT page.commandRequested(ItemId::BankSwitching, bank); });
    connect(detailsButton, &QToolButton::toggled, &page, [this](bool on) { details->setVisible(on); });
    connect(
        view->selectionModel(), &QItemSelectionModel::currentChanged, &page,
        [this](const QModelIndex& index) { details->setRow(filter.mapToSource(index.siblingAtColumn(0))); });
    connect(view, &SettingsView::editingChanged, &page,
            [this](const QModelIndex& index) { filter.setPinned(filter.mapToSource(index)); });
    connect(view, &SettingsView::orderRequested, &page,
            [this](const QModelIndex& index) { popUpOrders(index); });
    connect(view, &SettingsView::revertRequested, &page, [this] {
        if (const SettingRow* row = currentRow())
            menus.revert(*row);
    });
    connect(view, &SettingsView::editRefused, &page,
            [this](const QModelIndex& index) { explainRefusal(index); });
    connect(view, &SettingsView::copyRequested, &page, [this] {
        if (const SettingRow* row = currentRow())
            menus.copyRow(*row);
    });
    connect(view, &SettingsView::detailsRequested, &page, [this] { showDetails(true); });
    connect(view, &QWidget::customContextMenuRequested, &page,
            [this](const QPoint& at) { popUpContext(at); });
    connect(&menus, &RowMenus::editRequested, &page,
            [this](const SettingRow* row) { view->editRow(filter.mapFromSource(model.indexOf(row))); });
    connect(&menus, &RowMenus::detailsRequested, &page, [this] { showDetails(true); });
    connect(&menus, &RowMenus::commandRequested, &page, &SettingsPage::commandRequested);
    connect(details, &DetailsPane::editRequested, &page,
            [this](const SettingRow* row) { view->editRow(filter.mapFromSource(model.indexOf(row))); });
    connect(details, &DetailsPane::keepMineRequested, &page,
            [this](const SettingRow* row) { menus.keepMine(*row); });
    connect(details, &DetailsPane::takeSensorsRequested, &page,
            [this](const SettingRow* row) { menus.revert(*row); });
    connect(&filter, &QAbstractItemModel::rowsRemoved, &page, [this] { refreshEmptyText(); });
    connect(&filter, &QAbstractItemModel::rowsInserted, &page,
            [this](const QModelIndex& parent, int first, int last) {
                // A row that comes back does not arrive folded away.
                if (filter.isActive()) {
                    view->expand(parent);
                    for (int row = first; row <= last; ++row)
                        view->expandRecursively(filter.index(row, 0, parent));
                }
                refreshEmptyText();
            });
    connect(&Theme::instance(), &Theme::changed, &page, [this] { refreshStaleNote(); });
    auto* down = new QShortcut(Qt::Key_Down, filterBox);
    down->setContext(Qt::WidgetShortcut);
    connect(down, &QShortcut::activated, &page, [this] { view->setFocus(); });
}

void SettingsPage::setSession(SensorSession* session)
{
    if (session == d->model.session())
        return;
    d->view->releaseEditing();
    if (d->model.session())
        disconnect(d->model.session(), nullptr, this, nullptr);
    d->model.setSession(session);
    d->banks->setSession(session);
    d->details->sessionChanged();
    d->view->expandAll();
    d->view->measureColumns(true);
    if (session) {
        connect(session, &SensorSession::connectionChanged, this, [this] {
            d->refreshStaleNote();
            d->view->measureColumns();
        });
        connect(session, &SensorSession::identityChanged, this, [this] { d->view->measureColumns(); });
        connect(session, &QObject::destroyed, this, [this] {
            d->banks->setSession(nullptr);
            d->details->sessionChanged();
            d->refreshEmptyText();
            d->refreshStaleNote();
        });
        d->view->setCurrentIndex(d->filter.index(0, 0));
    }
    d->refreshEmptyText();
    d->refreshStaleNote();
}

void SettingsPage::Private::filterChanged()
{
    const QPersistentModelIndex current = filter.mapToSource(view->currentIndex());
    filter.setText(filterBox->text());
    filter.setChangedOnly(changedOnly->isChecked());
    view->expandAll();
    if (!filter.isActive())
        view->measureColumns();
    if (current.isValid())
        select(current);
    if (!view->currentIndex().isValid())
        view->setCurrentIndex(firstItem());
    refreshEmptyText();
}

void SettingsPage::Private::select(const QModelIndex& sourceIndex)
{
    const QModelIndex index = filter.mapFromSource(sourceIndex);
    if (!index.isValid())
        return;
    for (QModelIndex above = index.parent(); above.isValid(); above = above.parent())
        view->expand(above);
    view->setCurrentIndex(index);
    view->scrollTo(index);
}

QModelIndex SettingsPage::Private::firstItem() const
{
    QModelIndex index = filter.index(0, 0);
    while (filter.hasChildren(index) && index.isValid())
        index = filter.index(0, 0, index);
    return index;
}

void SettingsPage::Private::explainRefusal(const QModelIndex& index)
{
    const SettingRow* row = model.row(filter.mapToSource(index));
    if (!row || !model.session())
        return;
    const QString reason = RowFacts(*row, *model.session()).whyNot();
    const QRect cell = view->visualRect(index);
    QToolTip::showText(view->viewport()->mapToGlobal(cell.bottomLeft()), reason, view->viewport());
}

void SettingsPage::Private::refreshEmptyText()
{
    if (!model.session())
        view->setEmptyText(tr("No sensor is chosen. Connect one to see its settings."));
    else if (filter.isChangedOnly() && filter.text().trimmed().isEmpty())
        view->setEmptyText(tr("Nothing is changed. Every new value is the one in the sensor."));
    else if (filter.isChangedOnly())
        view->setEmptyText(
            tr("No changed item matches “%1”. Clear the filter or “Changed only”.").arg(filter.text()));
    else
        view->setEmptyText(tr("No item matches “%1”. Clear the filter to see all.").arg(filter.text()));
}

void SettingsPage::Private::refreshStaleNote()
{
    const SensorSession* session = model.session();
    const bool known = session && !session->heldValues().isEmpty();
    staleNote->setVisible(known && session->isStale());
    staleNote->setText(
        session && session->connection() == sensor::Connection::Reading
            ? tr("Reading the settings; values in italics are the last ones known.")
            : tr("Not connected: values in italics are the last ones known. Edits are kept, and written "
                 "only when you apply them."));
    staleNote->setStyleSheet(QStringLiteral("background: %1; color: %2;")
                                 .arg(color(ColorRole::Edit).name(), color(ColorRole::Text).name()));
}

void SettingsPage::Private::showDetails(bool visible)
{
    detailsButton->setChecked(visible);
    if (splitter->sizes().value(1) == 0) // dragged shut
        splitter->setSizes({page.width() - narrowDetailsWidth, narrowDetailsWidth});
    details->setFocus();
}

void SettingsPage::Private::popUpOrders(const QModelIndex& proxyIndex)
{
    const SettingRow* row = model.row(filter.mapToSource(proxyIndex));
    if (!row)
        return;
    const QRect cell = view->visualRect(proxyIndex);
    menus.popUpOrders(*row, view->viewport()->mapToGlobal(cell.bottomLeft()), view);
}

void SettingsPage::Private::popUpContext(const QPoint& position)
{
    // The menu key gives a place of its own; the menu belongs to the current row then.
    QModelIndex index = view->indexAt(position);
    if (!index.isValid())
        index = view->currentIndex();
    const SettingRow* row = model.row(filter.mapToSource(index));
    if (!row)
        return;
    view->setCurrentIndex(index);
    menus.popUpContext(*row, view->viewport()->mapToGlobal(position), view);
}

void SettingsPage::focusFilter()
{
    d->filterBox->setFocus(Qt::ShortcutFocusReason);
    d->filterBox->selectAll();
}

void SettingsPage::showItem(ItemId item)
{
    const QModelIndex index = d->model.indexOf(item);
    if (!index.isValid())
        return;
    if (!d->filter.mapFromSource(index).isValid()) {
        d->filterBox->clear();
        d->changedOnly->setChecked(false);
    }
    d->select(index);
}

bool SettingsPage::finishEditing()
{
    if (!d->view->finishEditing())
        return false;
    if (!d->model.hasWrongInput())
        return true;
    // Typed before and out of sight since: shown again, in its editor.
    for (const SettingRow* row : d->model.tree()->all()) {
        if (d->model.wrongInput(*row).text.isEmpty())
            continue;
        showItem(row->first()->id);
        d->view->editRow(d->filter.mapFromSource(d->model.indexOf(row)));
        return d->view->finishEditing();
    }
    return true;
}

void SettingsPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int wanted = width() < narrowPage ? narrowDetailsWidth : detailsWidth;
    const auto sizes = d->splitter->sizes();
    if (sizes.value(1) > 0 || !isVisible())
        d->splitter->setSizes({qMax(0, width() - wanted), wanted});
}

} // namespace lds::ui

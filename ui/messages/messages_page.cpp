#include "messages_page.h"

#include "message_delegates.h"
#include "message_details.h"
#include "message_export.h"
#include "message_model.h"
#include "message_text.h"
#include "save_dialog.h"
#include "theme.h"

#include <optional>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QSet>
#include <QSplitter>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

namespace lds::ui {

namespace {

constexpr int batchMs = 50;        ///< Messages reach the table at most this often …
constexpr int typingPauseMs = 150; ///< … and a filter is applied once typing pauses.

} // namespace

struct MessagesPage::Private {
    Private(MessagesPage& page, MessageLog& frames)
        : q(page)
        , log(frames)
    {}

    void build();
    QWidget* buildFilterRow();
    QWidget* buildChoiceRow();
    void buildTable();
    void connectControls();
    void retranslate();
    void takeWaiting();
    void append(const QList<ports::Frame>& frames);
    void applyFilter();
    void setPaused(bool on);
    void clear();
    void copy() const;
    void askWhereToSave();
    void showCounts();
    void showSelected();
    void sayResult(const QString& text, bool failed);
    bool isAtBottom() const;
    QList<int> selectedRows() const;

    MessagesPage& q;
    MessageLog& log;
    MessageModel model;
    MessageStore held; ///< What arrives while paused.
    bool paused = false;
    quint64 dropped = 0;
    QString peer;
    QSet<QString> peers; ///< All that have been seen since the last Clear.
    QString lastPeer;
    QTimer batch;
    QTimer typing;

    QLineEdit* text = nullptr;
    QCheckBox* thisSensor = nullptr;
    QCheckBox* hidePolls = nullptr;
    QCheckBox* failures = nullptr;
    QPushButton* pause = nullptr;
    QPushButton* clearAll = nullptr;
    QPushButton* copySelected = nullptr;
    QPushButton* save = nullptr;
    QLabel* counts = nullptr;
    QLabel* result = nullptr;
    QTableView* table = nullptr;
    QLabel* nothing = nullptr; ///< Over the empty table: why it is empty.
    QAction* copyAction = nullptr;
    MessageDetails* details = nullptr;
};

MessagesPage::MessagesPage(MessageLog& log, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(*this, log))
{
    d->build();
    d->retranslate();
    d->connectControls();
    d->applyFilter();
    d->takeWaiting();
}

MessagesPage::~MessagesPage() = default;

const MessageModel& MessagesPage::model() const { return d->model; }

void MessagesPage::setPeer(const QString& peer)
{
    d->peer = peer;
    d->thisSensor->setEnabled(!peer.isEmpty());
    d->applyFilter();
}

void MessagesPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        d->retranslate();
        d->showCounts();
        d->showSelected();
    }
}

void MessagesPage::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Find))
        d->text->setFocus(Qt::ShortcutFocusReason);
    else if (event->key() == Qt::Key_Space)
        d->setPaused(!d->paused);
    else
        QWidget::keyPressEvent(event);
}

void MessagesPage::Private::build()
{
    buildTable();
    details = new MessageDetails(&q);
    auto* parts = new QSplitter(Qt::Vertical, &q);
    parts->addWidget(table);
    parts->addWidget(details);
    parts->setStretchFactor(0, 1);
    parts->setStretchFactor(1, 0);
    parts->setCollapsible(0, false);
    parts->setSizes({1000, 96});
    parts->setHandleWidth(1);

    auto* card = new QFrame(&q);
    card->setProperty("card", true);
    auto* inside = new QVBoxLayout(card);
    inside->setContentsMargins(1, Theme::unit, 1, Theme::unit);
    inside->setSpacing(0);
    inside->addWidget(buildFilterRow());
    inside->addWidget(buildChoiceRow());
    inside->addWidget(parts, 1);
    auto* outside = new QVBoxLayout(&q);
    outside->setContentsMargins(0, 0, 0, 0);
    outside->addWidget(card);
    batch.setSingleShot(true);
    batch.setInterval(batchMs);
    typing.setSingleShot(true);
    typing.setInterval(typingPauseMs);
}

QWidget* MessagesPage::Private::buildFilterRow()
{
    auto* bar = new QWidget(&q);
    const auto icon = [](const char* name) { return Theme::instance().icon(QString::fromLatin1(name)); };
    text = new QLineEdit(bar);
    text->setClearButtonEnabled(true);
    text->addAction(icon("search"), QLineEdit::LeadingPosition);
    pause = new QPushButton(icon("pause"), {}, bar);
    pause->setCheckable(true);
    clearAll = new QPushButton(icon("clear"), {}, bar);
    copySelected = new QPushButton(icon("copy"), {}, bar);
    save = new QPushButton(icon("export"), {}, bar);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(2 * Theme::unit, Theme::unit, 2 * Theme::unit, Theme::unit);
    row->setSpacing(2 * Theme::unit);
    row->addWidget(text, 1);
    for (QPushButton* button : {pause, clearAll, copySelected, save})
        row->addWidget(button);
    return bar;
}

QWidget* MessagesPage::Private::buildChoiceRow()
{
    auto* bar = new QWidget(&q);
    thisSensor = new QCheckBox(bar);
    hidePolls = new QCheckBox(bar);
    failures = new QCheckBox(bar);
    hidePolls->setChecked(true);
    counts = new QLabel(bar);
    counts->setProperty("muted", true);
    counts->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    result = new QLabel(bar);
    result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    result->setWordWrap(true);
    result->hide();
    auto* row = new QHBoxLayout;
    row->setSpacing(4 * Theme::unit);
    for (QCheckBox* box : {thisSensor, hidePolls, failures})
        row->addWidget(box);
    row->addWidget(counts, 1);
    auto* rows = new QVBoxLayout(bar);
    rows->setContentsMargins(2 * Theme::unit, 0, 2 * Theme::unit, Theme::unit);
    rows->setSpacing(Theme::unit);
    rows->addLayout(row);
    rows->addWidget(result);
    return bar;
}

void MessagesPage::Private::buildTable()
{
    table = new QTableView(&q);
    table->setModel(&model);
    table->setItemDelegate(new CellDelegate(table));
    table->setItemDelegateForColumn(MessageModel::MessageColumn, new SentenceDelegate(table));
    table->setItemDelegateForColumn(MessageModel::BytesColumn, new BytesDelegate(table));
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setStyleSheet(QStringLiteral("QTableView::item { padding: 0 %1px; }").arg(2 * Theme::unit));
    table->setShowGrid(false);
    table->setWordWrap(false);
    table->setTabKeyNavigation(false);
    table->setCornerButtonEnabled(false);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->verticalHeader()->hide();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 6);

    const QFontMetrics metrics = table->fontMetrics();
    QHeaderView* header = table->horizontalHeader();
    header->setHighlightSections(false);
    header->setMinimumSectionSize(32);
    const auto setWidth = [&](int column, const QString& widest) {
        table->setColumnWidth(column, metrics.horizontalAdvance(widest) + 6 * Theme::unit);
    };
    setWidth(MessageModel::TimeColumn, QStringLiteral("00:00:00.000"));
    setWidth(MessageModel::DirectionColumn, QStringLiteral("Way"));
    setWidth(MessageModel::RoundTripColumn, QStringLiteral("0000.0"));
    setWidth(MessageModel::SensorColumn, QStringLiteral("modbus-tcp://127.0.0.1:00000"));
    header->setSectionResizeMode(QHeaderView::Interactive);
    header->setSectionResizeMode(MessageModel::MessageColumn, QHeaderView::Stretch);
    header->setSectionResizeMode(MessageModel::BytesColumn, QHeaderView::Stretch);

    table->setColumnHidden(MessageModel::SensorColumn, true);

    nothing = new QLabel(table->viewport());
    nothing->setProperty("muted", true);
    nothing->setAlignment(Qt::AlignCenter);
    nothing->setWordWrap(true);
    nothing->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* middle = new QVBoxLayout(table->viewport());
    middle->addWidget(nothing);

    copyAction = new QAction(table);
    copyAction->setShortcut(QKeySequence::Copy);
    copyAction->setShortcutContext(Qt::WidgetShortcut);
    copyAction->setIcon(Theme::instance().icon(QStringLiteral("copy")));
    table->addAction(copyAction);
    table->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void MessagesPage::Private::connectControls()
{
    // Queued: links record in their own threads.
    QObject::connect(
        &log, &MessageLog::waiting, &q,
        [this] {
            if (!batch.isActive())
                batch.start();
        },
        Qt::QueuedConnection);
    QObject::connect(&batch, &QTimer::timeout, &q, [this] { takeWaiting(); });
    QObject::connect(&typing, &QTimer::timeout, &q, [this] { applyFilter(); });
    QObject::connect(text, &QLineEdit::textChanged, &q, [this] { typing.start(); });
    QObject::connect(text, &QLineEdit::returnPressed, &q, [this] { applyFilter(); });
    for (QCheckBox* box : {thisSensor, hidePolls, failures})
        QObject::connect(box, &QCheckBox::toggled, &q, [this] { applyFilter(); });
    QObject::connect(pause, &QPushButton::clicked, &q, [this](bool on) { setPaused(on); });
    QObject::connect(clearAll, &QPushButton::clicked, &q, [this] { clear(); });
    QObject::connect(copySelected, &QPushButton::clicked, &q, [this] { copy(); });
    QObject::connect(copyAction, &QAction::triggered, &q, [this] { copy(); });
    QObject::connect(save, &QPushButton::clicked, &q, [this] { askWhereToSave(); });
    QObject::connect(table->selectionModel(), &QItemSelectionModel::selectionChanged, &q,
                     [this] { showSelected(); });
    QObject::connect(table->selectionModel(), &QItemSelectionModel::currentChanged, &q,
                     [this] { showSelected(); });
    QObject::connect(&model, &QAbstractItemModel::modelReset, &q, [this] { showSelected(); });
    // The rows a person looks at stay in place when older ones go.
    QObject::connect(&model, &QAbstractItemModel::rowsRemoved, &q,
                     [this](const QModelIndex&, int first, int last) {
                         QScrollBar* bar = table->verticalScrollBar();
                         const int above = std::min(last + 1, bar->value()) - first;
                         if (above > 0 && !isAtBottom())
                             bar->setValue(bar->value() - above);
                     });
    QObject::connect(&Theme::instance(), &Theme::changed, &q, [this] { showSelected(); });
}

void MessagesPage::Private::retranslate()
{
    text->setPlaceholderText(MessagesPage::tr("Filter by words, registers or bytes"));
    text->setAccessibleName(MessagesPage::tr("Filter of messages"));
    thisSensor->setText(MessagesPage::tr("This sensor only"));
    hidePolls->setText(MessagesPage::tr("Hide polls"));
    hidePolls->setToolTip(
        MessagesPage::tr("Leaves out the steady reading of the measured value. A poll that fails is shown."));
    failures->setText(MessagesPage::tr("Failures only"));
    failures->setToolTip(MessagesPage::tr("Refused, unanswered or not understood, and lost connections"));
    pause->setText(MessagesPage::tr("Pause"));
    pause->setToolTip(MessagesPage::tr("Hold the list still while messages keep being recorded (Space)"));
    clearAll->setText(MessagesPage::tr("Clear"));
    clearAll->setToolTip(MessagesPage::tr("Forget all messages recorded so far"));
    copySelected->setText(MessagesPage::tr("Copy"));
    copySelected->setToolTip(MessagesPage::tr("Copy the selected messages as text"));
    copyAction->setText(MessagesPage::tr("Copy"));
    save->setText(MessagesPage::tr("Save…"));
    save->setToolTip(MessagesPage::tr("Save the messages shown as CSV or text"));
    table->setAccessibleName(MessagesPage::tr("Messages"));
    showCounts();
}

void MessagesPage::Private::takeWaiting()
{
    const QList<ports::Frame> frames = log.take(&dropped);
    if (paused) {
        for (const ports::Frame& frame : frames)
            held.append(frame);
        held.trim();
    } else if (!frames.isEmpty()) {
        const bool follow = isAtBottom();
        const int before = model.rowCount();
        append(frames);
        if (follow && model.rowCount() != before)
            table->scrollToBottom();
    }
    showCounts();
}

/// The column of sensors takes its room only where there is more than one to tell apart.
void MessagesPage::Private::append(const QList<ports::Frame>& frames)
{
    for (const ports::Frame& frame : frames) {
        if (peers.isEmpty() || frame.peer != lastPeer)
            peers.insert(lastPeer = frame.peer);
    }
    table->setColumnHidden(MessageModel::SensorColumn, peers.size() < 2);
    model.append(frames);
}

void MessagesPage::Private::applyFilter()
{
    typing.stop();
    const MessageFilter filter{text->text(), peer, thisSensor->isChecked() && !peer.isEmpty(),
                               hidePolls->isChecked(), failures->isChecked()};
    if (filter == model.filter())
        return;
    const QModelIndex current = table->currentIndex();
    std::optional<MessageStore::Key> selected;
    if (current.isValid() && table->selectionModel()->isRowSelected(current.row()))
        selected = model.keyAt(current.row());
    const bool follow = isAtBottom();
    model.setFilter(filter);
    const std::optional<int> row = selected ? model.rowOf(*selected) : std::nullopt;
    if (row)
        table->selectRow(*row);
    if (row && !follow)
        table->scrollTo(model.index(*row, 0), QAbstractItemView::PositionAtCenter);
    else
        table->scrollToBottom();
    showCounts();
}

void MessagesPage::Private::setPaused(bool on)
{
    takeWaiting();
    paused = on;
    pause->setChecked(on);
    pause->setIcon(Theme::instance().icon(on ? QStringLiteral("play") : QStringLiteral("pause")));
    if (!on) {
        const bool follow = isAtBottom();
        dropped += held.trimmed();
        append(held.takeAll());
        if (follow)
            table->scrollToBottom();
    }
    showCounts();
}

void MessagesPage::Private::clear()
{
    log.take();
    held.clear();
    model.clear();
    peers.clear();
    dropped = 0;
    result->hide();
    showCounts();
}

void MessagesPage::Private::copy() const
{
    const QString selected = q.copyText();
    if (!selected.isEmpty())
        QApplication::clipboard()->setText(selected);
}

QString MessagesPage::copyText() const
{
    QString lines;
    for (const int row : d->selectedRows())
        lines += tabLine(messageFields(d->model.frameAt(row))) + QLatin1Char('\n');
    return lines;
}

void MessagesPage::Private::askWhereToSave()
{
    QFileDialog* dialog = makeSaveDialog(&q);
    QObject::connect(dialog, &QFileDialog::fileSelected, &q, [this](const QString& path) { q.saveTo(path); });
    dialog->open();
}

bool MessagesPage::saveTo(const QString& path)
{
    QList<ports::Frame> frames;
    frames.reserve(d->model.rowCount());
    for (int row = 0; row < d->model.rowCount(); ++row)
        frames.append(d->model.frameAt(row));
    const auto saved = saveMessages(path, frames);
    if (saved)
        d->sayResult(tr("Saved in %1. Messages: %2").arg(path).arg(frames.size()), false);
    else
        d->sayResult(
            tr("The messages could not be saved in %1: %2. Choose another folder, or make room there.")
                .arg(path, saved.error()),
            true);
    return saved.has_value();
}

void MessagesPage::Private::sayResult(const QString& sentence, bool failed)
{
    result->setText(sentence);
    result->setProperty("error", failed);
    result->setProperty("muted", !failed);
    result->style()->unpolish(result);
    result->style()->polish(result);
    result->show();
}

void MessagesPage::Private::showCounts()
{
    const QLocale locale;
    const auto number = [&](qulonglong count) { return locale.toString(count); };
    QStringList parts;
    if (paused)
        parts += MessagesPage::tr("Paused, %1 waiting").arg(number(qulonglong(held.size())));
    parts += MessagesPage::tr("%1 of %2 shown")
                 .arg(number(qulonglong(model.rowCount())), number(qulonglong(model.store().size())));
    if (const quint64 gone = model.store().trimmed() + dropped; gone > 0)
        parts += MessagesPage::tr("%1 oldest removed").arg(number(gone));
    const QString sentence = parts.join(QStringLiteral(" · "));
    if (counts->text() != sentence)
        counts->setText(sentence);
    nothing->setVisible(model.rowCount() == 0);
    nothing->setText(
        model.store().size() == 0
            ? MessagesPage::tr("No messages yet. They appear here as soon as a sensor is connected.")
            : MessagesPage::tr("None of the recorded messages passes the filter."));
    clearAll->setEnabled(model.store().size() > 0 || held.size() > 0);
    save->setEnabled(model.rowCount() > 0);
}

void MessagesPage::Private::showSelected()
{
    const QList<int> rows = selectedRows();
    copySelected->setEnabled(!rows.isEmpty());
    const QModelIndex current = table->currentIndex();
    if (rows.isEmpty())
        details->clear();
    else
        details->show(
            model.frameAt(current.isValid() && rows.contains(current.row()) ? current.row() : rows.first()));
}

bool MessagesPage::Private::isAtBottom() const
{
    const QScrollBar* bar = table->verticalScrollBar();
    return bar->value() >= bar->maximum();
}

QList<int> MessagesPage::Private::selectedRows() const
{
    QList<int> rows;
    for (const QModelIndex& index : table->selectionModel()->selectedRows())
        rows.append(index.row());
    std::sort(rows.begin(), rows.end());
    return rows;
}

} // namespace lds::ui

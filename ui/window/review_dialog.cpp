#include "review_dialog.h"

#include "apply_summary.h"
#include "command_texts.h"
#include "review_table_model.h"
#include "sentences.h"
#include "theme.h"

#include <algorithm>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace lds::ui {

using catalog::ItemId;
using sensor::SensorSession;

ReviewDialog::ReviewDialog(SensorSession& session, QWidget* parent)
    : QDialog(parent)
    , m_session(&session)
    , m_model(new ReviewTableModel(session, this))
    , m_title(new QLabel(this))
    , m_summary(new QLabel(this))
    , m_problems(new QWidget(this))
    , m_why(new QLabel(this))
    , m_order(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_progressText(new QLabel(this))
{
    setObjectName(QStringLiteral("reviewDialog"));
    setWindowTitle(tr("Review and apply \u2013 %1").arg(session.name()));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(sizeHint());

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 16, 20, 16);
    column->setSpacing(12);
    m_title->setProperty("title", true);
    column->addWidget(m_title);
    m_summary->setObjectName(QStringLiteral("applySummary"));
    m_summary->setWordWrap(true);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_summary->hide();
    column->addWidget(m_summary);
    column->addWidget(buildTable(), 1);
    m_problems->setObjectName(QStringLiteral("reviewProblems"));
    auto* problems = new QVBoxLayout(m_problems);
    problems->setContentsMargins(0, 0, 0, 0);
    problems->setSpacing(4);
    column->addWidget(m_problems);
    m_why->setObjectName(QStringLiteral("whyNotNow"));
    m_why->setWordWrap(true);
    m_why->setProperty("error", true);
    column->addWidget(m_why);
    m_order->setProperty("muted", true);
    m_order->setWordWrap(true);
    column->addWidget(m_order);
    buildButtons(column);

    connect(&session, &SensorSession::pendingChanged, this, &ReviewDialog::refresh);
    connect(&session, &SensorSession::heldChanged, this, &ReviewDialog::refresh);
    connect(&session, &SensorSession::busyChanged, this, &ReviewDialog::refresh);
    connect(&session, &SensorSession::connectionChanged, this, &ReviewDialog::refresh);
    connect(&session, &SensorSession::readinessChanged, this, &ReviewDialog::refresh);
    connect(&session, &SensorSession::applyProgress, this, &ReviewDialog::progress);
    connect(&session, &SensorSession::applyFinished, this, &ReviewDialog::finished);
    connect(&session, &QObject::destroyed, this, &QDialog::reject);
    setApplying(session.isApplying());
    refresh();
}

QWidget* ReviewDialog::buildTable()
{
    m_table = new QTableView(this);
    m_table->setObjectName(QStringLiteral("reviewTable"));
    m_table->setAccessibleName(tr("Changes to apply"));
    m_table->setModel(m_model);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(28);
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setProperty("card", true);
    QHeaderView* header = m_table->horizontalHeader();
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(ReviewTableModel::Note, QHeaderView::Stretch);
    connect(m_table, &QTableView::activated, this, [this](const QModelIndex& index) {
        Q_EMIT jumpRequested(m_model->rows().at(index.row()).items.first());
    });
    return m_table;
}

void ReviewDialog::buildButtons(QVBoxLayout* column)
{
    m_apply = new QPushButton(this);
    m_apply->setObjectName(QStringLiteral("applyButton"));
    m_apply->setProperty("primary", true);
    m_apply->setDefault(true);
    m_stop = new QPushButton(tr("&Stop after this write"), this);
    m_stop->setObjectName(QStringLiteral("stopButton"));
    m_stop->setAutoDefault(false);
    m_close = new QPushButton(tr("&Close"), this);
    m_close->setObjectName(QStringLiteral("closeButton"));
    m_close->setAutoDefault(false);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress of writing"));
    m_progressText->setObjectName(QStringLiteral("progressText"));

    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_progressText);
    row->addWidget(m_progress, 1);
    row->addStretch(0);
    row->addWidget(m_stop);
    row->addWidget(m_close);
    row->addWidget(m_apply);
    column->addLayout(row);
    connect(m_apply, &QPushButton::clicked, this, &ReviewDialog::start);
    connect(m_stop, &QPushButton::clicked, this, [this] {
        m_stop->setEnabled(false);
        m_progressText->setText(tr("Stopping after this write…"));
        if (m_session)
            m_session->cancelApply();
    });
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
}

void ReviewDialog::refresh()
{
    if (!m_session)
        return;
    const auto& rows = m_model->rows();
    const int conflicts = int(std::ranges::count(rows, true, &ReviewTableModel::Row::conflict));
    const int count = int(rows.size()) - conflicts; // what is in conflict waits for a decision
    m_title->setText(rows.isEmpty()     ? tr("Nothing to apply")
                     : rows.size() == 1 ? tr("1 change")
                                        : tr("%1 changes").arg(rows.size()));
    m_apply->setText(count == 1 ? tr("&Apply 1 change") : tr("&Apply %1 changes").arg(count));
    if (!m_session->isApplying()) {
        showProblems();
        showOrder();
    }
    m_apply->setEnabled(count > 0 && m_session->canWrite() && !m_session->isApplying() &&
                        (conflicts > 0 || m_session->problems().isEmpty()));
    const QString why = m_session->isApplying() ? QString() : whyNotNow(*m_session);
    m_why->setText(why);
    m_why->setVisible(!why.isEmpty());
}

void ReviewDialog::showProblems()
{
    const auto lines =
        m_problems->findChildren<QFrame*>(QStringLiteral("problem"), Qt::FindDirectChildrenOnly);
    for (QFrame* line : lines) {
        line->hide();
        line->setObjectName({});
        line->deleteLater(); // one of its buttons may be what brought us here
    }
    addConflicts();
    settings::Values goal = m_session->heldValues();
    goal.insert(m_session->pending().wantedValues());
    for (const auto& refusal : m_session->problems())
        addProblem(refusalSentence(refusal, m_session->model(), goal),
                   refusal.items.isEmpty() ? ItemId::HighSetValue : refusal.items.first());
    m_problems->setVisible(
        !m_problems->findChildren<QFrame*>(QStringLiteral("problem"), Qt::FindDirectChildrenOnly).isEmpty());
}

namespace {

/// A line under the table: icon, sentence, and room for buttons.
QHBoxLayout* makeLine(QWidget* parent, const QString& icon, const QString& sentence)
{
    auto* line = new QFrame(parent);
    line->setObjectName(QStringLiteral("problem"));
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    auto* mark = new QLabel(line);
    mark->setPixmap(Theme::instance().icon(icon, ColorRole::Warning).pixmap(16, 16));
    auto* text = new QLabel(sentence, line);
    text->setWordWrap(true);
    text->setObjectName(QStringLiteral("problemText"));
    row->addWidget(mark, 0, Qt::AlignTop);
    row->addWidget(text, 1);
    parent->layout()->addWidget(line);
    return row;
}

QPushButton* addButton(QHBoxLayout* row, const QString& text)
{
    auto* button = new QPushButton(text, row->parentWidget());
    button->setAutoDefault(false);
    row->addWidget(button, 0, Qt::AlignTop);
    return button;
}

} // namespace

void ReviewDialog::addProblem(const QString& sentence, ItemId jumpTo)
{
    QHBoxLayout* row = makeLine(m_problems, QStringLiteral("state-warning"), sentence);
    QPushButton* jump = addButton(row, tr("Show"));
    jump->setObjectName(QStringLiteral("jumpButton"));
    jump->setAccessibleDescription(sentence);
    connect(jump, &QPushButton::clicked, this, [this, jumpTo] { Q_EMIT jumpRequested(jumpTo); });
}

void ReviewDialog::addConflicts()
{
    for (const auto& change : m_model->rows()) {
        if (!change.conflict)
            continue;
        QHBoxLayout* row = makeLine(m_problems, QStringLiteral("conflict"),
                                    tr("%1: you want %2, the sensor holds %3 now (%4).")
                                        .arg(change.name, change.wanted, change.held, change.note));
        QPushButton* mine = addButton(row, tr("Keep mine"));
        mine->setObjectName(QStringLiteral("keepMineButton"));
        QPushButton* theirs = addButton(row, tr("Take the sensor's"));
        theirs->setObjectName(QStringLiteral("takeTheirsButton"));
        connect(mine, &QPushButton::clicked, this, [this, items = change.items] {
            for (const ItemId item : items) {
                if (m_session)
                    m_session->keepMine(item);
            }
        });
        connect(theirs, &QPushButton::clicked, this, [this, items = change.items] {
            if (m_session)
                m_session->revert(items);
        });
    }
}

void ReviewDialog::showOrder()
{
    const auto plan = m_session->plan();
    QStringList names;
    if (plan && std::ranges::none_of(m_model->rows(), &ReviewTableModel::Row::conflict)) {
        for (const auto& write : plan->steps)
            names += writeName(write, *m_session);
    }
    m_order->setVisible(names.size() > 1);
    m_order->setText(tr("Written in this order, each one allowed by the sensor when its turn comes: %1.")
                         .arg(names.join(QStringLiteral(", "))));
}

void ReviewDialog::start()
{
    if (!m_session)
        return;
    m_summary->hide();
    setApplying(true);
    progress(0, int(m_model->rows().size()));
    if (!m_session->apply())
        setApplying(false);
    refresh();
}

void ReviewDialog::progress(int done, int total)
{
    m_progress->setRange(0, qMax(1, total));
    m_progress->setValue(done);
    if (m_stop->isEnabled())
        m_progressText->setText(tr("Writing %1 of %2…").arg(qMin(done + 1, total)).arg(total));
}

void ReviewDialog::finished(const sensor::ApplyReport& report)
{
    setApplying(false);
    if (!m_session)
        return;
    const ApplySummary summary = summarize(report, *m_session);
    if (report.allDone()) {
        Q_EMIT applied(summary.byTheWay.isEmpty() ? summary.headline
                                                  : summary.headline + u' ' + summary.byTheWay);
        accept();
        return;
    }
    QStringList lines{QStringLiteral("<b>%1</b>").arg(summary.headline.toHtmlEscaped())};
    for (const QString& sentence : summary.sentences)
        lines += QStringLiteral("• ") + sentence.toHtmlEscaped();
    if (!summary.byTheWay.isEmpty())
        lines += summary.byTheWay.toHtmlEscaped();
    m_summary->setText(lines.join(QStringLiteral("<br>")));
    m_summary->setAccessibleName(summary.headline + u' ' + summary.sentences.join(u' '));
    m_summary->show();
    refresh();
}

void ReviewDialog::setApplying(bool applying)
{
    m_progress->setVisible(applying);
    m_progressText->setVisible(applying);
    m_stop->setVisible(applying);
    m_stop->setEnabled(applying);
    m_close->setVisible(!applying);
    m_apply->setVisible(!applying);
    m_table->setEnabled(!applying);
    if (applying) {
        m_problems->hide();
        m_order->hide();
        m_stop->setFocus();
    }
}

void ReviewDialog::done(int result)
{
    if (m_session && m_session->isApplying())
        return;
    QDialog::done(result);
}

} // namespace lds::ui

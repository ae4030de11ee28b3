#include "change_communication_dialog.h"

#include "catalog.h"
#include "height_keeper.h"
#include "item_text.h"
#include "serial_texts.h"
#include "theme.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStyle>
#include <QVBoxLayout>

namespace lds::ui {

using catalog::ItemId;
using procedures::ChangeProblem;
using procedures::CommunicationChange;
using sensor::SensorSession;

namespace {

QString stepWord(CommunicationChange::StepState state)
{
    using StepState = CommunicationChange::StepState;
    switch (state) {
    case StepState::Waiting:
        return ChangeCommunicationDialog::tr("to do");
    case StepState::UnderWay:
        return ChangeCommunicationDialog::tr("under way");
    case StepState::Done:
        return ChangeCommunicationDialog::tr("done");
    case StepState::Failed:
        return ChangeCommunicationDialog::tr("failed");
    case StepState::NotNeeded:
        return ChangeCommunicationDialog::tr("not needed");
    }
    return {};
}

QIcon stepIcon(CommunicationChange::StepState state)
{
    using StepState = CommunicationChange::StepState;
    const Theme& theme = Theme::instance();
    switch (state) {
    case StepState::Waiting:
    case StepState::NotNeeded:
        return theme.icon(QStringLiteral("state-offline"), ColorRole::Muted);
    case StepState::UnderWay:
        return theme.icon(QStringLiteral("state-busy"), ColorRole::Accent);
    case StepState::Done:
        return theme.icon(QStringLiteral("state-ok"), ColorRole::Go);
    case StepState::Failed:
        return theme.icon(QStringLiteral("state-error"), ColorRole::Error);
    }
    return {};
}

void setPrimary(QPushButton* button, bool primary)
{
    if (button->property("primary").toBool() == primary)
        return;
    button->setProperty("primary", primary);
    button->setDefault(primary);
    button->style()->unpolish(button);
    button->style()->polish(button);
}

} // namespace

ChangeCommunicationDialog::ChangeCommunicationDialog(SensorSession& session,
                                                     const sensor::Workspace& workspace,
                                                     ports::LinkFactory& links, ports::Scheduler& scheduler,
                                                     QWidget* parent)
    : QDialog(parent)
    , m_session(&session)
    , m_change(session, workspace, links, scheduler)
{
    setObjectName(QStringLiteral("changeCommunicationDialog"));
    setWindowTitle(tr("Address, speed and parity \u2013 %1").arg(session.name()));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(560);
    new HeightKeeper(this);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 16, 20, 16);
    column->setSpacing(12);
    auto* title = new QLabel(tr("Change how %1 speaks on the line").arg(session.name()), this);
    title->setProperty("title", true);
    column->addWidget(title);
    auto* now = new QLabel(tr("Now: %1, address %2, %3")
                               .arg(session.url().host)
                               .arg(session.url().unit)
                               .arg(serialText(session.url().serial)),
                           this);
    now->setProperty("muted", true);
    now->setObjectName(QStringLiteral("changeNow"));
    column->addWidget(now);
    buildFields(column);
    buildSteps(column);
    m_sentence = new QLabel(this);
    m_sentence->setObjectName(QStringLiteral("changeSentence"));
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addWidget(m_sentence);
    column->addStretch(1);
    buildButtons(column);

    connect(&m_change, &CommunicationChange::changed, this, &ChangeCommunicationDialog::refresh);
    connect(&m_change, &CommunicationChange::ended, this, [this] {
        if (m_change.sensorAt())
            Q_EMIT moved(*m_change.sensorAt());
    });
    connect(&session, &QObject::destroyed, this, [this] { QDialog::done(Rejected); });
    m_unit->setFocus();
    m_unit->selectAll();
    refresh();
}

void ChangeCommunicationDialog::buildFields(QVBoxLayout* column)
{
    m_fields = new QWidget(this);
    auto* form = new QFormLayout(m_fields);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(8);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    const auto add = [&](ItemId item, QWidget* field, const char* name) {
        const auto& description = catalog::hlG2(item);
        auto* label =
            new QLabel(QStringLiteral("%1  %2").arg(description.menu).arg(itemName(description)), m_fields);
        label->setBuddy(field);
        field->setObjectName(QLatin1StringView(name));
        field->setAccessibleName(itemName(description));
        field->setToolTip(itemHelp(description));
        field->setMinimumWidth(160);
        form->addRow(label, field);
    };
    m_unit = new QSpinBox(m_fields);
    const auto& limits = catalog::hlG2(ItemId::DeviceAddress).limitsFor(m_session->model());
    m_unit->setRange(limits.minimum, limits.maximum);
    m_speed = new QComboBox(m_fields);
    fillSpeeds(m_speed);
    m_parity = new QComboBox(m_fields);
    fillParities(m_parity);
    add(ItemId::DeviceAddress, m_unit, "newUnit");
    add(ItemId::CommunicationSpeed, m_speed, "newSpeed");
    add(ItemId::ParityStopBit, m_parity, "newParity");
    m_unit->setValue(m_session->url().unit);
    showSerial(m_session->url().serial, m_speed, m_parity);

    m_problem = new QLabel(m_fields);
    m_problem->setObjectName(QStringLiteral("changeProblem"));
    m_problem->setProperty("error", true);
    m_problem->setWordWrap(true);
    form->addRow(QString(), m_problem);
    auto* hint =
        new QLabel(tr("Saving stores all settings of the sensor as they are now, not only these."), m_fields);
    hint->setProperty("muted", true);
    hint->setWordWrap(true);
    form->addRow(hint);
    column->addWidget(m_fields);
    connect(m_unit, &QSpinBox::valueChanged, this, &ChangeCommunicationDialog::refresh);
    connect(m_speed, &QComboBox::currentIndexChanged, this, &ChangeCommunicationDialog::refresh);
    connect(m_parity, &QComboBox::currentIndexChanged, this, &ChangeCommunicationDialog::refresh);
}

void ChangeCommunicationDialog::buildSteps(QVBoxLayout* column)
{
    auto* card = new QFrame(this);
    card->setProperty("card", true);
    card->setObjectName(QStringLiteral("changeSteps"));
    auto* grid = new QGridLayout(card);
    grid->setContentsMargins(12, 10, 12, 10);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(1, 1);
    int row = 0;
    for (const State step : {State::Checking, State::Writing, State::Saving, State::Resetting,
                             State::Reopening, State::Verifying}) {
        auto* icon = new QLabel(card);
        auto* text = new QLabel(card);
        text->setObjectName(QStringLiteral("step.%1").arg(int(step)));
        grid->addWidget(icon, row, 0);
        grid->addWidget(text, row, 1);
        m_lines.append({step, icon, text});
        ++row;
    }
    column->addWidget(card);
}

void ChangeCommunicationDialog::buildButtons(QVBoxLayout* column)
{
    const auto make = [this](const char* name) {
        auto* button = new QPushButton(this);
        button->setObjectName(QLatin1StringView(name));
        button->setAutoDefault(false);
        return button;
    };
    m_close = make("closeButton");
    m_search = make("searchButton");
    m_search->setText(tr("&Search again"));
    m_back = make("backButton");
    m_back->setText(tr("&Go back to the former settings"));
    m_start = make("changeButton");
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addStretch(1);
    for (QPushButton* button : {m_close, m_search, m_back, m_start})
        row->addWidget(button);
    column->addLayout(row);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_search, &QPushButton::clicked, &m_change, &CommunicationChange::searchAgain);
    connect(m_back, &QPushButton::clicked, &m_change, &CommunicationChange::goBack);
    connect(m_start, &QPushButton::clicked, this, &ChangeCommunicationDialog::start);
}

ports::SerialSettings ChangeCommunicationDialog::serial() const { return serialOf(m_speed, m_parity); }

quint8 ChangeCommunicationDialog::unit() const { return quint8(m_unit->value()); }

void ChangeCommunicationDialog::start()
{
    if (m_change.state() == State::Done || m_change.state() == State::WentBack)
        return accept();
    m_change.start(serial(), unit());
    refresh();
}

void ChangeCommunicationDialog::refresh()
{
    if (!m_session)
        return;
    const State state = m_change.state();
    const bool canBegin = state == State::Idle || state == State::Failed;
    m_fields->setEnabled(canBegin);

    const ChangeProblem obstacle = m_change.obstacle(serial(), unit());
    const bool saidBelow = state == State::Failed && obstacle == ChangeProblem::NotPossibleNow;
    const bool shown = canBegin && !saidBelow && obstacle != ChangeProblem::None &&
                       obstacle != ChangeProblem::NothingToChange;
    m_problem->setText(shown ? obstacleSentence(obstacle, unit()) : QString());
    m_problem->setVisible(shown);

    showSteps();
    showSentence();
    showButtons();
}

void ChangeCommunicationDialog::showSteps()
{
    using StepState = CommunicationChange::StepState;
    for (const StepLine& line : std::as_const(m_lines)) {
        StepState state = m_change.stepState(line.step);
        if (m_change.state() == State::Idle && line.step == State::Checking &&
            unit() == m_session->url().unit)
            state = StepState::NotNeeded;
        const QString text = changeStepText(line.step);
        line.icon->setPixmap(stepIcon(state).pixmap(16, 16));
        line.text->setText(state == StepState::NotNeeded ? tr("%1 (not needed)").arg(text) : text);
        line.text->setAccessibleName(tr("%1: %2").arg(text, stepWord(state)));
        line.text->setEnabled(state != StepState::NotNeeded);
        QFont font = line.text->font();
        font.setBold(state == StepState::UnderWay);
        line.text->setFont(font);
    }
}

void ChangeCommunicationDialog::showSentence()
{
    QString sentence = changeSentence(m_change);
    if (m_change.isRunning() && m_change.isGoingBack())
        sentence = tr("Going back to the former settings…");
    else if (m_change.state() == State::Reopening)
        sentence = tr("Waiting for the sensor to answer at address %1 with %2…")
                       .arg(m_session->url().unit)
                       .arg(serialText(m_session->url().serial));
    m_sentence->setText(sentence);
    m_sentence->setProperty("error", m_change.state() == State::Failed);
    m_sentence->style()->unpolish(m_sentence);
    m_sentence->style()->polish(m_sentence);
}

void ChangeCommunicationDialog::showButtons()
{
    const State state = m_change.state();
    const bool ended = state == State::Done || state == State::WentBack;
    m_close->setText(m_change.isRunning() ? (state == State::Reopening ? tr("&Stop waiting") : tr("&Stop"))
                                          : tr("&Close"));
    m_close->setVisible(!ended);
    m_close->setEnabled(!m_change.isRunning() || m_change.canCancel());
    m_search->setVisible(m_change.canSearch());
    m_back->setVisible(m_change.canGoBack());
    m_start->setText(ended ? tr("&Close") : state == State::Failed ? tr("&Try again") : tr("Chan&ge"));
    m_start->setVisible(!m_change.canSearch());
    m_start->setEnabled(ended || m_change.obstacle(serial(), unit()) == ChangeProblem::None);
    setPrimary(m_start, !m_change.canGoBack() && !m_change.canSearch());
    setPrimary(m_back, m_change.canGoBack());
    setPrimary(m_search, m_change.canSearch());
}

void ChangeCommunicationDialog::done(int result)
{
    if (m_change.isRunning()) {
        m_change.cancel(); // what has been written is put back; the dialog shows it and stays
        return;
    }
    QDialog::done(result);
}

} // namespace lds::ui

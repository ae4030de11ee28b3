#include "connect_dialog.h"

#include "connection_form.h"
#include "height_keeper.h"
#include "sentences.h"
#include "theme.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace lds::ui {

using sensor::Connection;
using sensor::SensorSession;

ConnectDialog::ConnectDialog(sensor::Workspace& workspace, RecentConnections recent,
                             const ports::SerialPorts* ports, QWidget* parent)
    : QDialog(parent)
    , m_workspace(workspace)
    , m_recent(recent)
    , m_form(new ConnectionForm(ports, this))
    , m_progress(new QProgressBar(this))
    , m_state(new QLabel(this))
    , m_connect(new QPushButton(tr("Co&nnect"), this))
{
    setObjectName(QStringLiteral("connectDialog"));
    m_form->setObjectName(QStringLiteral("connectionForm"));
    setWindowTitle(tr("Connect a sensor"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(620);
    new HeightKeeper(this);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 16, 20, 16);
    column->setSpacing(12);
    auto* title = new QLabel(tr("Connect a sensor"), this);
    title->setProperty("title", true);
    column->addWidget(title);
    column->addWidget(m_form);
    buildRecent(column);
    column->addStretch(1);

    m_progress->setRange(0, 0);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Connecting"));
    m_progress->hide();
    column->addWidget(m_progress);
    m_state->setObjectName(QStringLiteral("connectState"));
    m_state->setWordWrap(true);
    m_state->hide();
    column->addWidget(m_state);

    auto* buttons = new QDialogButtonBox(this);
    m_connect->setObjectName(QStringLiteral("connectButton"));
    m_connect->setProperty("primary", true);
    m_connect->setDefault(true);
    buttons->addButton(m_connect, QDialogButtonBox::AcceptRole);
    QPushButton* cancel = buttons->addButton(QDialogButtonBox::Cancel);
    cancel->setObjectName(QStringLiteral("cancelButton"));
    cancel->setAutoDefault(false);
    column->addWidget(buttons);
    m_form->setFocus();
    connect(m_connect, &QPushButton::clicked, this, &ConnectDialog::start);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_form, &ConnectionForm::scanRequested, this, [this] {
        const QString port = m_form->serialPort();
        reject();
        Q_EMIT scanRequested(port);
    });
    connect(m_form, &ConnectionForm::edited, this, [this] {
        giveUp(); // what failed was asked for with other words
        m_state->hide();
        m_connect->setText(tr("Co&nnect"));
    });
}

void ConnectDialog::buildRecent(QVBoxLayout* column)
{
    const QList<RecentConnection> recent = m_recent.list();
    if (recent.isEmpty())
        return;
    auto* heading = new QLabel(tr("RECENT"), this);
    heading->setProperty("heading", true);
    column->addWidget(heading);
    m_recentList = new QListWidget(this);
    m_recentList->setObjectName(QStringLiteral("recentList"));
    m_recentList->setAccessibleName(tr("Recent connections"));
    for (const RecentConnection& each : recent) {
        const QString url = each.url.toString();
        m_recentList->addItem(each.name.isEmpty() ? url : QStringLiteral("%1 \u2013 %2").arg(each.name, url));
    }
    const int rowHeight = m_recentList->sizeHintForRow(0) + 2;
    m_recentList->setMaximumHeight(rowHeight * qMin(4, int(recent.size())) + 6);
    column->addWidget(m_recentList);
    m_form->fill(recent.first());
    connect(m_recentList, &QListWidget::currentRowChanged, this, [this, recent](int row) {
        if (row >= 0)
            m_form->fill(recent.at(row));
    });
    connect(m_recentList, &QListWidget::itemDoubleClicked, this, &ConnectDialog::start);
}

void ConnectDialog::start()
{
    if (m_progress->isVisible())
        return;
    const QList<ports::ConnectionUrl> urls = m_form->checkAll();
    if (urls.isEmpty())
        return;
    const ports::ConnectionUrl& url = urls.first();
    m_further = urls.sliced(1);
    if (m_session && m_session->connection() == Connection::Reconnecting) {
        setConnecting(true);
        m_session->retryNow();
        return;
    }
    const auto before = m_workspace.sessions();
    m_session = m_workspace.add(url, m_form->nameFor(url));
    m_isNew = !before.contains(m_session);
    if (!m_isNew && m_session->url().viewOnly != url.viewOnly) {
        showFailure(url.viewOnly
                        ? tr("This sensor is in the list already, with writing. Remove it there first.")
                        : tr("This sensor is in the list already, for viewing only. Remove it there first."));
        m_session = nullptr;
        return;
    }
    if (!m_isNew && url.sensor)
        m_session->setModel(*url.sensor);
    if (!m_isNew && m_session->url().serial != url.serial && !m_session->isReady())
        m_session->moveTo(url);
    connect(m_session, &SensorSession::connectionChanged, this, &ConnectDialog::follow, Qt::UniqueConnection);
    setConnecting(true);
    if (m_session->connection() == Connection::Closed)
        m_session->open();
    follow();
}

void ConnectDialog::follow()
{
    if (!m_session)
        return;
    switch (m_session->connection()) {
    case Connection::Opening:
        m_state->setText(tr("Connecting to %1…").arg(m_session->url().place()));
        m_state->setVisible(true);
        return;
    case Connection::Reading:
    case Connection::Ready: // an HL-G2 has answered; the window shows how the reading goes
        connected();
        return;
    case Connection::Reconnecting: {
        if (m_session->linkReport().state == ports::LinkState::Opening)
            return; // the next try is under way
        const QString sentence = openFailureSentence(m_session->linkReport(), m_session->url());
        showFailure(sentence.isEmpty() ? connectionWord(m_session->connection()) : sentence);
        return;
    }
    case Connection::Closed:
        return;
    }
}

void ConnectDialog::connected()
{
    for (const ports::ConnectionUrl& url : std::as_const(m_further)) {
        SensorSession* session = m_workspace.add(url, m_form->nameFor(url));
        session->open();
        m_recent.add({session->url(), m_form->nameFor(url)});
    }
    if (!m_further.isEmpty())
        m_workspace.setCurrent(m_session);
    m_recent.add({m_session->url(), m_form->nameFor(m_session->url())});
    m_isNew = false;
    accept();
}

void ConnectDialog::setConnecting(bool connecting)
{
    m_progress->setVisible(connecting);
    m_form->setEnabled(!connecting);
    if (m_recentList)
        m_recentList->setEnabled(!connecting);
    m_connect->setEnabled(!connecting);
    if (connecting) {
        m_state->setProperty("error", false);
        m_state->setStyleSheet({});
    }
}

void ConnectDialog::showFailure(const QString& sentence)
{
    const bool wasAsked = m_progress->isVisible(); // else it is one of the tries in between
    setConnecting(false);
    m_state->setText(sentence);
    m_state->setProperty("error", true);
    m_state->setStyleSheet({}); // takes the property up
    m_state->setVisible(true);
    m_connect->setText(tr("&Retry"));
    if (wasAsked)
        m_connect->setFocus();
}

void ConnectDialog::giveUp()
{
    if (m_session)
        m_session->disconnect(this);
    if (m_session && m_isNew)
        m_workspace.remove(m_session);
    m_session = nullptr;
    m_isNew = false;
}

void ConnectDialog::done(int result)
{
    if (result != Accepted)
        giveUp();
    QDialog::done(result);
}

} // namespace lds::ui

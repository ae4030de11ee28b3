#include "status_line.h"

#include "item_text.h"
#include "sentences.h"

#include <QLabel>

namespace lds::ui {

using catalog::ItemId;
using sensor::SensorSession;

namespace {
constexpr int sayingMs = 6000;
}

StatusLine::StatusLine(ports::Scheduler& scheduler, QWidget* parent)
    : QStatusBar(parent)
    , m_scheduler(scheduler)
    , m_connection(new QLabel(this))
    , m_protocol(new QLabel(this))
    , m_said(new QLabel(this))
    , m_viewOnly(new QLabel(tr("View only"), this))
    , m_pending(new QLabel(this))
    , m_bank(new QLabel(this))
{
    setObjectName(QStringLiteral("statusLine"));
    setSizeGripEnabled(false);
    setContentsMargins(12, 2, 12, 2);
    const auto name = [](QLabel* label, const char* objectName) {
        label->setObjectName(QLatin1StringView(objectName));
        label->setProperty("muted", true);
        label->setContentsMargins(0, 0, 12, 0);
    };
    name(m_connection, "connectionWord");
    name(m_protocol, "protocolText");
    name(m_said, "said");
    name(m_viewOnly, "viewOnlyText");
    name(m_pending, "pendingText");
    name(m_bank, "bankText");
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    m_connection->setFont(bold);
    m_connection->setProperty("muted", false);
    addWidget(m_connection);
    addWidget(m_protocol);
    addWidget(m_said, 1);
    addPermanentWidget(m_viewOnly);
    addPermanentWidget(m_pending);
    addPermanentWidget(m_bank);
    refresh();
}

void StatusLine::setSession(SensorSession* session)
{
    if (m_session)
        m_session->disconnect(this);
    m_session = session;
    sayUntilDone({}); // it was about the other one
    if (session) {
        connect(session, &SensorSession::connectionChanged, this, &StatusLine::refresh);
        connect(session, &SensorSession::pendingChanged, this, &StatusLine::refresh);
        connect(session, &SensorSession::heldChanged, this, &StatusLine::refresh);
    }
    refresh();
}

void StatusLine::refresh()
{
    const bool exists = m_session;
    m_connection->setText(exists ? connectionWord(m_session->connection()) : tr("No sensor"));
    m_protocol->setVisible(exists && m_session->isReady());
    m_viewOnly->setVisible(exists && m_session->isViewOnly());
    m_pending->setVisible(exists);
    m_bank->setVisible(exists && m_session->held(ItemId::BankSwitching));
    if (!exists)
        return;
    m_protocol->setText(m_session->linkReport().lowWordFirst ? tr("Modbus TCP, low word first")
                                                             : tr("Modbus TCP, high word first"));
    const int edits = m_session->pending().count();
    m_pending->setText(edits == 0 ? tr("nothing pending") : tr("%1 pending").arg(edits));
    if (const auto bank = m_session->held(ItemId::BankSwitching))
        m_bank->setText(
            displayValue(m_session->catalog().item(ItemId::BankSwitching), m_session->model(), *bank));
}

void StatusLine::say(const QString& text)
{
    sayUntilDone(text);
    m_timer = m_scheduler.after(sayingMs, this, [this] {
        m_timer = 0;
        m_said->clear();
    });
}

void StatusLine::sayUntilDone(const QString& text)
{
    m_scheduler.cancel(m_timer);
    m_timer = 0;
    m_said->setText(text);
}

QString StatusLine::said() const { return m_said->text(); }

} // namespace lds::ui

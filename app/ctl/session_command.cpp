#include "session_command.h"

#include "console.h"
#include "sentences.h"
#include "texts.h"

namespace lds::ctl {

using sensor::Connection;

namespace {

/// The link has timeouts of its own; this one only makes sure that there is an end.
constexpr int longestOpeningMs = 30'000;

} // namespace

SessionCommand::SessionCommand(CommandLine line, sensor::SensorSession& session, ports::Scheduler& scheduler,
                               Console& console)
    : m_line(std::move(line))
    , m_session(session)
    , m_scheduler(scheduler)
    , m_console(console)
{}

void SessionCommand::start()
{
    if (!prepare())
        return;
    connect(&m_session, &sensor::SensorSession::connectionChanged, this,
            &SessionCommand::onConnectionChanged);
    connect(&m_session, &sensor::SensorSession::readinessChanged, this, &SessionCommand::onReadinessChanged);
    m_openingTimer = m_scheduler.after(longestOpeningMs, this, [this] { onOpeningTimeout(); });
    m_session.open();
}

void SessionCommand::onConnectionChanged()
{
    if (m_finished)
        return;
    switch (m_session.connection()) {
    case Connection::Ready:
        if (!std::exchange(m_wasReady, true)) {
            m_scheduler.cancel(m_openingTimer);
            onReady();
        }
        break;
    case Connection::Reconnecting: // The session would try for ever; a command line tries once.
    case Connection::Closed:
        if (m_wasReady) {
            onLost(failureSentence());
        } else {
            m_console.message(failureSentence());
            finish(ExitCode::Refused);
        }
        break;
    case Connection::Opening:
    case Connection::Reading:
        break;
    }
}

void SessionCommand::onReadinessChanged()
{
    if (m_finished || m_wasReady || !m_session.isSensorNotReady())
        return;
    ports::LinkReport report;
    report.failure = ports::OpenFailure::NotReady;
    m_console.message(ui::openFailureSentence(report, m_session.url()));
    finish(ExitCode::Refused);
}

void SessionCommand::onOpeningTimeout()
{
    if (m_finished || m_wasReady)
        return;
    ports::LinkReport report;
    report.failure = ports::OpenFailure::NoAnswer;
    m_console.message(ui::openFailureSentence(report, m_session.url()));
    finish(ExitCode::Refused);
}

QString SessionCommand::failureSentence() const
{
    const ports::LinkReport& report = m_session.linkReport();
    const QString where = m_session.url().place();
    QString sentence =
        report.failure == ports::OpenFailure::Lost || report.failure == ports::OpenFailure::None
            ? Texts::tr("The connection to %1 was cut. Check power and cable, then try again.").arg(where)
            : ui::openFailureSentence(report, m_session.url());
    if (!report.detail.isEmpty())
        sentence += QStringLiteral(" (%1)").arg(report.detail);
    return sentence;
}

void SessionCommand::onLost(const QString& sentence)
{
    m_console.message(sentence);
    finish(ExitCode::Refused);
}

void SessionCommand::finish(ExitCode code)
{
    if (std::exchange(m_finished, true))
        return;
    m_scheduler.cancel(m_openingTimer);
    Q_EMIT finished(code);
}

} // namespace lds::ctl

#pragma once

#include "command_line.h"
#include "exit_code.h"
#include "scheduler.h"
#include "sensor_session.h"

namespace lds::ctl {

class Console;

/// A command that needs a sensor: opens the session once and gives up, with a sentence, when that fails or
/// the connection is cut. finished() follows start() exactly once.
class SessionCommand : public QObject {
    Q_OBJECT

public:
    SessionCommand(CommandLine line, sensor::SensorSession& session, ports::Scheduler& scheduler,
                   Console& console);

    void start();

Q_SIGNALS:
    void finished(lds::ctl::ExitCode code);

protected:
    /// What can be proven wrong before a connection is made; false after a message, with finish() called.
    virtual bool prepare() { return true; }
    /// Everything has been read and the session is ready. Once.
    virtual void onReady() = 0;
    /// The connection was there and is gone; `sentence` says why.
    virtual void onLost(const QString& sentence);

    void finish(ExitCode code);
    bool isFinished() const { return m_finished; }
    const CommandLine& line() const { return m_line; }
    sensor::SensorSession& session() { return m_session; }
    ports::Scheduler& scheduler() { return m_scheduler; }
    Console& console() { return m_console; }

private:
    void onConnectionChanged();
    void onReadinessChanged();
    void onOpeningTimeout();
    QString failureSentence() const;

    CommandLine m_line;
    sensor::SensorSession& m_session;
    ports::Scheduler& m_scheduler;
    Console& m_console;
    ports::Scheduler::TimerId m_openingTimer = 0;
    bool m_wasReady = false;
    bool m_finished = false;
};

} // namespace lds::ctl

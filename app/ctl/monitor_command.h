#pragma once

#include "session_command.h"

#include <QFile>

namespace lds::ctl {

/// ldsctl monitor: a line for every measurement until the time is up, interrupt() or a lost connection,
/// and at the end how many polls were answered and lost.
class MonitorCommand final : public SessionCommand {
    Q_OBJECT

public:
    using SessionCommand::SessionCommand;

    void interrupt(); ///< Ctrl+C: ends as if the time were up.

protected:
    bool prepare() override;
    void onReady() override;
    void onLost(const QString& sentence) override;

private:
    void onMeasured();
    void onReadinessChanged();
    void print(const measurement::Measurement& sample);
    bool writeCsv(const QStringList& cells);
    void end(ExitCode code);

    QFile m_csv;
    qint64 m_startedNs = 0;
    bool m_saidNotReady = false;
};

} // namespace lds::ctl

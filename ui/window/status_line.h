#pragma once

#include "scheduler.h"
#include "sensor_session.h"

#include <QPointer>
#include <QStatusBar>

class QLabel;

namespace lds::ui {

/// The line at the bottom: connection, protocol, what was just done; pending edits and bank.
class StatusLine final : public QStatusBar {
    Q_OBJECT

public:
    StatusLine(ports::Scheduler& scheduler, QWidget* parent = nullptr);
    void setSession(sensor::SensorSession* session);
    /// Something that worked: shown for a few seconds, in place of a modal box.
    void say(const QString& text);
    /// Something under way: shown until the next saying.
    void sayUntilDone(const QString& text);
    QString said() const;

private:
    void refresh();

    ports::Scheduler& m_scheduler;
    QPointer<sensor::SensorSession> m_session;
    ports::Scheduler::TimerId m_timer = 0;
    QLabel* m_connection;
    QLabel* m_protocol;
    QLabel* m_said;
    QLabel* m_viewOnly;
    QLabel* m_pending;
    QLabel* m_bank;
};

} // namespace lds::ui

#pragma once

#include "scheduler.h"

#include <map>
#include <QPointer>

namespace lds::ports {

/// A clock that stands still until it is told to go on: for tests and for simulated time.
class ManualScheduler final : public Scheduler {
public:
    qint64 nowNs() const override { return m_nowNs; }
    qint64 wallMs() const override { return m_wallStartMs + m_nowNs / 1'000'000; }
    TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override;
    void cancel(TimerId timer) override;

    /// Moves time forward, running every timer that falls due, in order, at its own time.
    void advanceMs(qint64 ms) { advanceNs(ms * 1'000'000); }
    void advanceNs(qint64 ns);
    int pendingTimers() const { return int(m_timers.size()); }

private:
    struct Timer {
        TimerId id;
        QPointer<QObject> owner;
        std::function<void()> callback;
    };
    std::multimap<qint64, Timer> m_timers;
    qint64 m_nowNs = 1'000'000'000; ///< Not zero, so that "never" and "at the start" differ.
    qint64 m_wallStartMs = 1'700'000'000'000;
    TimerId m_next = 1;
};

} // namespace lds::ports

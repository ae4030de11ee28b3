#pragma once

#include "scheduler.h"

#include <functional>

namespace lds::scheduling {

/// Ticks at a steady rate on a scheduler's clock. A tick is due at start + n · interval: a late one does
/// not move those after it, and those that were missed altogether are reported, not made up for.
class PollTicker {
public:
    /// `tick` gets the number of ticks missed before this one. `owner`'s death stops the ticking.
    PollTicker(ports::Scheduler& scheduler, QObject* owner, std::function<void(quint64 missed)> tick);
    ~PollTicker();
    PollTicker(const PollTicker&) = delete;
    PollTicker& operator=(const PollTicker&) = delete;

    void start(int intervalMs); ///< ≥ 1; ticks at once, then at every interval. Restarts when running.
    void stop();
    bool isRunning() const { return m_intervalNs > 0; }
    int intervalMs() const;

private:
    void arm();
    void onDue();

    ports::Scheduler& m_scheduler;
    QObject* m_owner;
    std::function<void(quint64)> m_tick;
    ports::Scheduler::TimerId m_timer = 0;
    qint64 m_intervalNs = 0;
    qint64 m_dueNs = 0;
};

} // namespace lds::scheduling

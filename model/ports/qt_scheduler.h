#pragma once

#include "scheduler.h"

#include <memory>

namespace lds::ports {

/// The real one: the steady clock and precise single-shot timers.
///
/// It belongs to the thread that calls after() first: after(), cancel() and the destructor stay there, and
/// callbacks run there; owners live there, too. It may be made in another thread. The clocks may be read
/// from any thread. A callback may call anything here, but must not destroy the scheduler.
class QtScheduler final : public Scheduler {
public:
    QtScheduler();
    ~QtScheduler() override; ///< Drops every timer.
    QtScheduler(const QtScheduler&) = delete;
    QtScheduler& operator=(const QtScheduler&) = delete;

    qint64 nowNs() const override;
    qint64 wallMs() const override;
    /// A timer whose owner died takes no part in anything; it is forgotten when it falls due.
    TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override;
    void cancel(TimerId timer) override;

private:
    class Timers;
    std::unique_ptr<Timers>
        m_timers; ///< Made in the thread that uses it, since a QObject's timers run in its own.
    TimerId m_next = 1;
};

} // namespace lds::ports

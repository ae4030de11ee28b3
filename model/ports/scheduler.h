#pragma once

#include <functional>
#include <QObject>
#include <QtGlobal>

namespace lds::ports {

/// Time as the domain sees it: a monotonic clock, wall time, and timers. Injected everywhere, so that
/// tests drive it and nothing sleeps. A scheduler belongs to one thread; callbacks run in that thread's
/// event loop (QtScheduler) or inside advance() (ManualScheduler).
class Scheduler {
public:
    using TimerId = quint64; ///< 0 is never a timer.
    virtual ~Scheduler() = default;

    virtual qint64 nowNs() const = 0;  ///< Monotonic.
    virtual qint64 wallMs() const = 0; ///< Milliseconds since the epoch, UTC.
    /// Runs `callback` once after `delayMs` ≥ 0. Dropped without running when `owner` dies first.
    virtual TimerId after(int delayMs, QObject* owner, std::function<void()> callback) = 0;
    virtual void cancel(TimerId timer) = 0; ///< Unknown or finished timers are ignored.
};

} // namespace lds::ports

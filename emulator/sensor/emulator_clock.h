#pragma once

#include <functional>
#include <QObject>
#include <QtGlobal>

namespace lds::emulator {

/// Time as a virtual sensor sees it. Injected, so that tests drive it and nothing sleeps. A clock
/// belongs to one thread; its callbacks run there.
class EmulatorClock {
public:
    using TimerId = quint64; ///< 0 is never a timer.
    virtual ~EmulatorClock() = default;

    virtual qint64 nowNs() const = 0; ///< Monotonic.
    /// Runs `callback` once after `delayMs` ≥ 0. Dropped without running when `owner` dies first.
    virtual TimerId after(int delayMs, QObject* owner, std::function<void()> callback) = 0;
    virtual void cancel(TimerId timer) = 0; ///< Unknown or finished timers are ignored.
};

} // namespace lds::emulator

#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <QObject>
#include <QtGlobal>
#include <utility>

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
    /// The same, once `timeNs` of nowNs() has come: as soon after it as the clock can tell, which is a
    /// millisecond unless it says otherwise.
    virtual TimerId at(qint64 timeNs, QObject* owner, std::function<void()> callback)
    {
        const qint64 delayMs = (timeNs - nowNs() + 999'999) / 1'000'000;
        return after(int(std::clamp<qint64>(delayMs, 0, std::numeric_limits<int>::max())), owner,
                     std::move(callback));
    }
    virtual void cancel(TimerId timer) = 0; ///< Unknown or finished timers are ignored.
};

} // namespace lds::emulator

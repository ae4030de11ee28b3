#pragma once

#include "emulator_clock.h"

#include <map>
#include <QPointer>
#include <utility>

namespace lds::emulator {

/// A clock that stands still until advance() is called: for tests.
class ManualClock final : public EmulatorClock {
public:
    qint64 nowNs() const override { return m_nowNs; }
    TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override;
    TimerId at(qint64 timeNs, QObject* owner,
               std::function<void()> callback) override; ///< To the nanosecond.
    void cancel(TimerId timer) override;

    /// Runs what falls due in order of its time, timers started meanwhile included.
    void advanceMs(qint64 milliseconds) { advanceNs(milliseconds * 1'000'000); }
    void advanceNs(qint64 nanoseconds);
    int pending() const { return int(m_timers.size()); }

private:
    struct Timer {
        QPointer<QObject> owner;
        std::function<void()> callback;
    };
    using Key = std::pair<qint64, TimerId>; ///< Due at, then in the order of starting.

    qint64 m_nowNs = 0;
    TimerId m_last = 0;
    std::map<Key, Timer> m_timers;
};

} // namespace lds::emulator

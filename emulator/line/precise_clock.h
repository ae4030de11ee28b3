#pragma once

#include "emulator_clock.h"

#include <map>
#include <memory>
#include <QObject>
#include <QPointer>
#include <utility>

class QSocketNotifier;

namespace lds::emulator {

/// Another clock whose at() is met within some ten microseconds, which is what a line of 230,400 bps takes
/// for a character. Where the system has no such timer (all but Linux) it is the other clock.
class PreciseClock final : public QObject, public EmulatorClock {
public:
    explicit PreciseClock(EmulatorClock& clock);
    ~PreciseClock() override;

    qint64 nowNs() const override { return m_clock.nowNs(); }
    TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override
    {
        return m_clock.after(delayMs, owner, std::move(callback));
    }
    TimerId at(qint64 timeNs, QObject* owner, std::function<void()> callback) override;
    void cancel(TimerId timer) override;

private:
    struct Timer {
        QPointer<QObject> owner;
        std::function<void()> callback;
    };
    using Key = std::pair<qint64, TimerId>;

    void arm();
    void runDue();

    EmulatorClock& m_clock;
    int m_descriptor = -1;
    std::unique_ptr<QSocketNotifier> m_notifier;
    std::map<Key, Timer> m_timers;
    TimerId m_last;
};

} // namespace lds::emulator

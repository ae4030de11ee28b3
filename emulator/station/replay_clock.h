#pragma once

#include "emulator_clock.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace lds::emulator {

/// The clock of a station's sensor: another clock, except while something that was due earlier is made up
/// for after a stall. Then it stands at that moment, though it never goes back behind what it has told.
class ReplayClock final : public EmulatorClock {
public:
    explicit ReplayClock(EmulatorClock& clock)
        : m_clock(clock)
    {}

    qint64 nowNs() const override
    {
        m_toldNs = std::max(m_toldNs, m_replayedNs.value_or(m_clock.nowNs()));
        return m_toldNs;
    }
    TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override
    {
        return m_clock.after(delayMs, owner, [this, run = std::move(callback)] {
            if (m_before)
                m_before();
            run();
        });
    }
    void cancel(TimerId timer) override { m_clock.cancel(timer); }

    /// Runs before whatever the sensor wanted to be woken for: the time to make up for what is late.
    void setBefore(std::function<void()> before) { m_before = std::move(before); }
    void standAt(qint64 timeNs) { m_replayedNs = timeNs; } ///< Until goOn().
    void goOn() { m_replayedNs.reset(); }

private:
    EmulatorClock& m_clock;
    std::function<void()> m_before;
    std::optional<qint64> m_replayedNs;
    mutable qint64 m_toldNs = 0;
};

} // namespace lds::emulator

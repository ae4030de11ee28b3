#include "manual_clock.h"

#include <algorithm>

namespace lds::emulator {

namespace {
constexpr qint64 nanosecondsPerMillisecond = 1'000'000;
}

EmulatorClock::TimerId ManualClock::after(int delayMs, QObject* owner, std::function<void()> callback)
{
    return at(m_nowNs + delayMs * nanosecondsPerMillisecond, owner, std::move(callback));
}

EmulatorClock::TimerId ManualClock::at(qint64 timeNs, QObject* owner, std::function<void()> callback)
{
    const TimerId id = ++m_last;
    m_timers.emplace(Key{timeNs, id}, Timer{owner, std::move(callback)});
    return id;
}

void ManualClock::cancel(TimerId id)
{
    std::erase_if(m_timers, [id](const auto& entry) { return entry.first.second == id; });
}

void ManualClock::advanceNs(qint64 nanoseconds)
{
    const qint64 until = m_nowNs + nanoseconds;
    while (!m_timers.empty() && m_timers.begin()->first.first <= until) {
        const auto node = m_timers.extract(m_timers.begin());
        m_nowNs = std::max(m_nowNs, node.key().first);
        if (node.mapped().owner)
            node.mapped().callback();
    }
    m_nowNs = until;
}

} // namespace lds::emulator

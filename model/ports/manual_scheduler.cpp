#include "manual_scheduler.h"

#include <algorithm>

namespace lds::ports {

Scheduler::TimerId ManualScheduler::after(int delayMs, QObject* owner, std::function<void()> callback)
{
    const TimerId id = m_next++;
    m_timers.emplace(m_nowNs + qint64(delayMs) * 1'000'000, Timer{id, owner, std::move(callback)});
    return id;
}

void ManualScheduler::cancel(TimerId timer)
{
    const auto found = std::find_if(m_timers.begin(), m_timers.end(),
                                    [timer](const auto& entry) { return entry.second.id == timer; });
    if (found != m_timers.end())
        m_timers.erase(found);
}

void ManualScheduler::advanceNs(qint64 ns)
{
    const qint64 end = m_nowNs + ns;
    while (!m_timers.empty() && m_timers.begin()->first <= end) {
        auto node = m_timers.extract(m_timers.begin());
        m_nowNs = std::max(m_nowNs, node.key());
        if (node.mapped().owner)
            node.mapped().callback();
    }
    m_nowNs = end;
}

} // namespace lds::ports

#include "poll_ticker.h"

namespace lds::scheduling {

namespace {
constexpr qint64 nsPerMs = 1'000'000;
}

PollTicker::PollTicker(ports::Scheduler& scheduler, QObject* owner, std::function<void(quint64)> tick)
    : m_scheduler(scheduler)
    , m_owner(owner)
    , m_tick(std::move(tick))
{}

PollTicker::~PollTicker() { stop(); }

void PollTicker::start(int intervalMs)
{
    stop();
    m_intervalNs = qMax(1, intervalMs) * nsPerMs;
    m_dueNs = m_scheduler.nowNs();
    arm();
}

void PollTicker::stop()
{
    m_scheduler.cancel(m_timer);
    m_timer = 0;
    m_intervalNs = 0;
}

int PollTicker::intervalMs() const { return int(m_intervalNs / nsPerMs); }

void PollTicker::arm()
{
    // To the nearest millisecond: a tick may be half of one early or late, and the rate holds.
    const qint64 waitNs = qMax<qint64>(0, m_dueNs - m_scheduler.nowNs());
    m_timer = m_scheduler.after(int((waitNs + nsPerMs / 2) / nsPerMs), m_owner, [this] { onDue(); });
}

void PollTicker::onDue()
{
    m_timer = 0;
    const qint64 lateNs = qMax<qint64>(0, m_scheduler.nowNs() - m_dueNs);
    const qint64 missed = lateNs / m_intervalNs;
    m_dueNs += (missed + 1) * m_intervalNs;
    arm();
    m_tick(quint64(missed)); // Last: it may stop or restart the ticking.
}

} // namespace lds::scheduling

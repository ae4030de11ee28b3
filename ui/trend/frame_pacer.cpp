#include "frame_pacer.h"

#include <algorithm>

namespace lds::ui {

namespace {
constexpr qint64 nsPerMs = 1'000'000;
}

FramePacer::FramePacer(ports::Scheduler& scheduler, QObject* owner, int intervalMs,
                       std::function<void()> frame)
    : m_scheduler(scheduler)
    , m_owner(owner)
    , m_intervalMs(intervalMs)
    , m_frame(std::move(frame))
    , m_lastNs(scheduler.nowNs() - intervalMs * nsPerMs)
{}

FramePacer::~FramePacer() { cancel(); }

void FramePacer::request()
{
    if (m_soon != 0)
        return;
    const qint64 dueNs = m_lastNs + m_intervalMs * nsPerMs;
    const qint64 waitMs = std::max<qint64>(0, (dueNs - m_scheduler.nowNs() + nsPerMs - 1) / nsPerMs);
    m_soon = m_scheduler.after(int(waitMs), m_owner, [this] {
        m_soon = 0;
        run();
    });
}

void FramePacer::requestAt(qint64 monotonicNs)
{
    if (m_later != 0 && m_laterNs == monotonicNs)
        return;
    m_scheduler.cancel(m_later);
    m_laterNs = monotonicNs;
    const qint64 waitMs = std::max<qint64>(0, (monotonicNs - m_scheduler.nowNs() + nsPerMs - 1) / nsPerMs);
    m_later = m_scheduler.after(int(waitMs), m_owner, [this] {
        m_later = 0;
        request();
    });
}

void FramePacer::cancel()
{
    m_scheduler.cancel(m_soon);
    m_scheduler.cancel(m_later);
    m_soon = 0;
    m_later = 0;
}

void FramePacer::run()
{
    m_lastNs = m_scheduler.nowNs();
    m_frame();
}

} // namespace lds::ui

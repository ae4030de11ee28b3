#include "precise_clock.h"

#include <algorithm>
#include <QSocketNotifier>

#ifdef Q_OS_LINUX
#include <sys/timerfd.h>
#include <unistd.h>
#endif

namespace lds::emulator {

namespace {
constexpr EmulatorClock::TimerId firstOwn = EmulatorClock::TimerId(1)
                                            << 63; ///< The other clock counts below.
} // namespace

EmulatorClock::TimerId PreciseClock::at(qint64 timeNs, QObject* owner, std::function<void()> callback)
{
    if (!m_notifier)
        return m_clock.at(timeNs, owner, std::move(callback));
    const TimerId id = ++m_last;
    m_timers.emplace(Key{timeNs, id}, Timer{owner, std::move(callback)});
    if (m_timers.begin()->first.second == id)
        arm();
    return id;
}

void PreciseClock::cancel(TimerId timer)
{
    if (timer <= firstOwn) {
        m_clock.cancel(timer);
        return;
    }
    std::erase_if(m_timers, [timer](const auto& entry) { return entry.first.second == timer; });
}

#ifdef Q_OS_LINUX

PreciseClock::PreciseClock(EmulatorClock& clock)
    : m_clock(clock)
    , m_descriptor(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC))
    , m_last(firstOwn)
{
    if (m_descriptor < 0)
        return;
    m_notifier = std::make_unique<QSocketNotifier>(m_descriptor, QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &PreciseClock::runDue);
}

PreciseClock::~PreciseClock()
{
    m_notifier.reset();
    if (m_descriptor >= 0)
        ::close(m_descriptor);
}

/// For the first timer; a cancelled one may wake it for nothing.
void PreciseClock::arm()
{
    if (m_timers.empty())
        return;
    constexpr qint64 second = 1'000'000'000;
    const qint64 leftNs = std::max<qint64>(m_timers.begin()->first.first - nowNs(), 1);
    const itimerspec when{{}, {time_t(leftNs / second), long(leftNs % second)}};
    ::timerfd_settime(m_descriptor, 0, &when, nullptr);
}

void PreciseClock::runDue()
{
    quint64 expirations = 0;
    [[maybe_unused]] const auto count = ::read(m_descriptor, &expirations, sizeof expirations);
    while (!m_timers.empty() && m_timers.begin()->first.first <= nowNs()) {
        const auto timer = m_timers.extract(m_timers.begin());
        if (timer.mapped().owner)
            timer.mapped().callback();
    }
    arm();
}

#else

PreciseClock::PreciseClock(EmulatorClock& clock)
    : m_clock(clock)
    , m_last(firstOwn)
{}

PreciseClock::~PreciseClock() = default;
void PreciseClock::arm() {}
void PreciseClock::runDue() {}

#endif

} // namespace lds::emulator

#include "system_clock.h"

#include <QTimer>

namespace lds::emulator {

SystemClock::SystemClock(QObject* parent)
    : QObject(parent)
{
    m_elapsed.start();
}

qint64 SystemClock::nowNs() const { return m_elapsed.nsecsElapsed(); }

EmulatorClock::TimerId SystemClock::after(int delayMs, QObject* owner, std::function<void()> callback)
{
    const TimerId id = ++m_last;
    auto* timer = new QTimer(owner); // dies with its owner
    timer->setSingleShot(true);
    timer->setTimerType(Qt::PreciseTimer);
    m_timers.insert(id, timer);
    connect(timer, &QTimer::timeout, this, [this, id, timer, run = std::move(callback)] {
        m_timers.remove(id);
        timer->deleteLater();
        run();
    });
    connect(timer, &QObject::destroyed, this, [this, id] { m_timers.remove(id); });
    timer->start(delayMs);
    return id;
}

void SystemClock::cancel(TimerId id)
{
    if (QTimer* timer = m_timers.take(id)) {
        timer->stop();
        timer->deleteLater();
    }
}

} // namespace lds::emulator

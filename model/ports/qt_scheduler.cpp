#include "qt_scheduler.h"

#include <chrono>
#include <QDateTime>

namespace lds::ports {

QtScheduler::~QtScheduler()
{
    for (QTimer* timer : std::as_const(m_timers))
        delete timer;
}

qint64 QtScheduler::nowNs() const
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

qint64 QtScheduler::wallMs() const { return QDateTime::currentMSecsSinceEpoch(); }

Scheduler::TimerId QtScheduler::after(int delayMs, QObject* owner, std::function<void()> callback)
{
    const TimerId id = m_next++;
    auto* timer = new QTimer;
    timer->setSingleShot(true);
    timer->setTimerType(Qt::PreciseTimer);
    m_timers.insert(id, timer);
    QObject::connect(timer, &QTimer::timeout, owner, [this, id, callback = std::move(callback)] {
        cancel(id);
        callback();
    });
    // The owner's death disconnects the callback; the timer itself must go then, too.
    QObject::connect(owner, &QObject::destroyed, timer, [this, id] { cancel(id); });
    timer->start(delayMs);
    return id;
}

void QtScheduler::cancel(TimerId timer)
{
    if (QTimer* found = m_timers.take(timer)) {
        found->stop();
        found->deleteLater();
    }
}

} // namespace lds::ports

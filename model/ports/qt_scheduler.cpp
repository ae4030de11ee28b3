#include "qt_scheduler.h"

#include <chrono>
#include <QDateTime>
#include <QHash>
#include <QPointer>
#include <QThread>
#include <QTimerEvent>

namespace lds::ports {

/// One object for all timers: nothing is allocated for deleteLater(), so nothing outlives the scheduler.
class QtScheduler::Timers final : public QObject {
public:
    void start(TimerId id, int delayMs, QObject* owner, std::function<void()> callback)
    {
        const int native = startTimer(delayMs, Qt::PreciseTimer);
        m_entries.insert(native, Entry{id, owner, std::move(callback)});
        m_natives.insert(id, native);
    }

    void cancel(TimerId id)
    {
        const auto native = m_natives.constFind(id);
        if (native == m_natives.cend())
            return;
        take(*native);
    }

protected:
    void timerEvent(QTimerEvent* event) override
    {
        // Taken out first: the callback may start and cancel timers.
        const Entry entry = take(event->timerId());
        if (entry.owner)
            entry.callback();
    }

private:
    struct Entry {
        TimerId id = 0;
        QPointer<QObject> owner;
        std::function<void()> callback;
    };

    Entry take(int native)
    {
        killTimer(native);
        Entry entry = m_entries.take(native);
        m_natives.remove(entry.id);
        return entry;
    }

    QHash<int, Entry> m_entries;
    QHash<TimerId, int> m_natives;
};

QtScheduler::QtScheduler() = default;

QtScheduler::~QtScheduler() { Q_ASSERT(!m_timers || m_timers->thread() == QThread::currentThread()); }

qint64 QtScheduler::nowNs() const
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

qint64 QtScheduler::wallMs() const { return QDateTime::currentMSecsSinceEpoch(); }

Scheduler::TimerId QtScheduler::after(int delayMs, QObject* owner, std::function<void()> callback)
{
    if (!m_timers)
        m_timers = std::make_unique<Timers>();
    Q_ASSERT(m_timers->thread() == QThread::currentThread());
    Q_ASSERT(owner && owner->thread() == QThread::currentThread());
    const TimerId id = m_next++;
    m_timers->start(id, qMax(0, delayMs), owner, std::move(callback));
    return id;
}

void QtScheduler::cancel(TimerId timer)
{
    if (!m_timers)
        return;
    Q_ASSERT(m_timers->thread() == QThread::currentThread());
    m_timers->cancel(timer);
}

} // namespace lds::ports

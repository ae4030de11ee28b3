#pragma once

#include "scheduler.h"

#include <QHash>
#include <QTimer>

namespace lds::ports {

/// The real one: steady clock and single-shot precise timers of the thread that calls after().
class QtScheduler final : public Scheduler {
public:
    QtScheduler() = default;
    ~QtScheduler() override;
    QtScheduler(const QtScheduler&) = delete;
    QtScheduler& operator=(const QtScheduler&) = delete;

    qint64 nowNs() const override;
    qint64 wallMs() const override;
    TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override;
    void cancel(TimerId timer) override;

private:
    QHash<TimerId, QTimer*> m_timers;
    TimerId m_next = 1;
};

} // namespace lds::ports

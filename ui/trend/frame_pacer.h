#pragma once

#include "scheduler.h"

#include <functional>
#include <QObject>

namespace lds::ui {

/// Turns any number of requests into at most one frame an interval: never one repaint per sample.
class FramePacer {
public:
    /// `owner` must outlive the pacer; `frame` runs in the scheduler's thread.
    FramePacer(ports::Scheduler& scheduler, QObject* owner, int intervalMs, std::function<void()> frame);
    ~FramePacer();
    FramePacer(const FramePacer&) = delete;
    FramePacer& operator=(const FramePacer&) = delete;

    void request();                     ///< A frame as soon as the interval allows.
    void requestAt(qint64 monotonicNs); ///< A frame then; a later call replaces an earlier one.
    void cancel();

private:
    void run();

    ports::Scheduler& m_scheduler;
    QObject* m_owner;
    int m_intervalMs;
    std::function<void()> m_frame;
    ports::Scheduler::TimerId m_soon = 0;
    ports::Scheduler::TimerId m_later = 0;
    qint64 m_laterNs = -1;
    qint64 m_lastNs;
};

} // namespace lds::ui

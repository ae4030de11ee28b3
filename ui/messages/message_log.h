#pragma once

#include "frame.h"

#include <QList>
#include <QMutex>
#include <QObject>

namespace lds::ui {

/// Collects the frames of all links, from any thread, and hands them to the GUI thread in batches.
/// Bounded: while the GUI does not take them, the oldest waiting frames go and are counted.
class MessageLog final : public QObject, public ports::FrameLog {
    Q_OBJECT

public:
    static constexpr int mostWaiting = 20'000;
    static constexpr qsizetype mostWaitingBytes = 16 * 1024 * 1024;

    explicit MessageLog(QObject* parent = nullptr);
    void record(const ports::Frame& frame) override;
    /// GUI thread: everything that waits. Adds to `dropped` how many went unseen since the last take().
    QList<ports::Frame> take(quint64* dropped = nullptr);

Q_SIGNALS:
    void waiting(); ///< Emitted once until the next take(), in the recording thread; connect queued.

private:
    QMutex m_mutex;
    QList<ports::Frame> m_waiting;
    qsizetype m_bytes = 0;
    quint64 m_dropped = 0;
    bool m_announced = false;
};

/// About what a frame occupies, for bounds in bytes.
qsizetype footprint(const ports::Frame& frame);

} // namespace lds::ui

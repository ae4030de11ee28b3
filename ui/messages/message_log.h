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
    explicit MessageLog(QObject* parent = nullptr);
    void record(const ports::Frame& frame) override;
    QList<ports::Frame> take(quint64* dropped = nullptr); ///< GUI thread: everything that waits.

Q_SIGNALS:
    void waiting(); ///< Emitted once until the next take(); connect queued.

private:
    QMutex m_mutex;
    QList<ports::Frame> m_waiting;
    quint64 m_dropped = 0;
    bool m_announced = false;
};

} // namespace lds::ui

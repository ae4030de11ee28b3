#pragma once

#include "emulator_clock.h"

#include <QElapsedTimer>
#include <QHash>

class QTimer;

namespace lds::emulator {

/// The machine's monotonic clock and the event loop's timers. Lives in the thread that uses it.
class SystemClock final : public QObject, public EmulatorClock {
    Q_OBJECT

public:
    explicit SystemClock(QObject* parent = nullptr);

    qint64 nowNs() const override;
    TimerId after(int delayMs, QObject* owner, std::function<void()> callback) override;
    void cancel(TimerId timer) override;

private:
    QElapsedTimer m_elapsed;
    QHash<TimerId, QTimer*> m_timers;
    TimerId m_last = 0;
};

} // namespace lds::emulator

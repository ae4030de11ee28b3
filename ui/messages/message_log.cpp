#include "message_log.h"

#include <utility>

namespace lds::ui {

MessageLog::MessageLog(QObject* parent)
    : QObject(parent)
{}

void MessageLog::record(const ports::Frame& frame)
{
    {
        const QMutexLocker lock(&m_mutex);
        m_waiting.append(frame);
        m_bytes += footprint(frame);
        while (m_waiting.size() > mostWaiting || (m_bytes > mostWaitingBytes && m_waiting.size() > 1)) {
            m_bytes -= footprint(m_waiting.constFirst());
            m_waiting.removeFirst();
            ++m_dropped;
        }
        if (std::exchange(m_announced, true))
            return;
    }
    Q_EMIT waiting(); // without the lock: a direct connection may take()
}

QList<ports::Frame> MessageLog::take(quint64* dropped)
{
    const QMutexLocker lock(&m_mutex);
    m_announced = false;
    m_bytes = 0;
    const quint64 lost = std::exchange(m_dropped, 0);
    if (dropped)
        *dropped += lost;
    return std::exchange(m_waiting, {});
}

qsizetype footprint(const ports::Frame& frame)
{
    // A heap block's own overhead counts too; protocol and peer are shared by all frames of a link.
    constexpr qsizetype block = 32;
    qsizetype bytes = qsizetype(sizeof(ports::Frame)) + block + frame.bytes.size();
    for (const QString& argument : frame.arguments)
        bytes += qsizetype(sizeof(QString)) + block + 2 * argument.size();
    return bytes;
}

} // namespace lds::ui

#include "frame_receiver.h"

#include <algorithm>
#include <utility>

namespace lds::emulator {

void FrameReceiver::feed(const QByteArray& bytes, modbus::RtuRate rate, qint64 nowNs)
{
    if (bytes.isEmpty())
        return;
    if (!m_receiving) {
        m_receiving = true;
        m_rate = rate;
        m_lastByteNs = nowNs;
    }
    // At another speed than the first bytes, or after a pause: noise (Modbus over serial line, 2.5.1.1).
    if (rate != m_rate || nowNs - m_lastByteNs > modbus::longestGapNs(rate))
        spoil();
    m_rate = rate;
    m_lastByteNs = std::max(m_lastByteNs, nowNs) + modbus::charactersNs(rate, bytes.size());
    if (m_bytes.size() + bytes.size() > modbus::longestRtuFrame)
        spoil();
    if (!m_spoiled)
        m_bytes += bytes;
}

void FrameReceiver::spoil()
{
    m_spoiled = m_receiving;
    m_bytes.clear();
}

std::optional<qint64> FrameReceiver::frameDueNs() const
{
    if (!m_receiving)
        return std::nullopt;
    return m_lastByteNs + modbus::frameSilenceNs(m_rate);
}

std::optional<QByteArray> FrameReceiver::take()
{
    QByteArray bytes = std::exchange(m_bytes, {});
    const bool spoiled = std::exchange(m_spoiled, false);
    m_receiving = false;
    if (spoiled || bytes.isEmpty())
        return std::nullopt;
    return bytes;
}

} // namespace lds::emulator

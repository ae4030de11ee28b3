#pragma once

#include "modbus_rtu_framing.h"

#include <optional>
#include <QByteArray>

namespace lds::emulator {

/// Finds the frames in what a client sends: what stands between two silences, in the line's time. Bytes that
/// come at once take their time on the line one after the other.
class FrameReceiver {
public:
    /// At `nowNs`, when frameDueNs() has not passed. A pause of more than 1.5 characters spoils the frame.
    void feed(const QByteArray& bytes, modbus::RtuRate rate, qint64 nowNs);
    /// What has come since the last silence is no frame, whatever follows.
    void spoil();
    /// When the silence after the last byte will be long enough; nothing while the line is quiet.
    std::optional<qint64> frameDueNs() const;
    /// What came before the silence; nothing when it cannot be a frame.
    std::optional<QByteArray> take();

    qint64 lastByteNs() const { return m_lastByteNs; } ///< When it is over on the line.

private:
    QByteArray m_bytes;
    modbus::RtuRate m_rate;
    bool m_receiving = false;
    bool m_spoiled = false;
    qint64 m_lastByteNs = 0;
};

} // namespace lds::emulator

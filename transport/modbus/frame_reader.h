#pragma once

#include "modbus_tcp_framing.h"

#include <optional>
#include <QByteArray>
#include <tl/expected.hpp>

namespace lds::modbus {

/// One answer as it came over the wire.
struct ReceivedFrame {
    TcpHeader header;
    QByteArray bytes; ///< Header and PDU.
    QByteArray pdu() const { return bytes.sliced(headerSize); }
};

/// Cuts a received stream into messages by their headers alone, and notices when it is no such stream.
class FrameReader {
public:
    enum class Fault {
        Header
    }; ///< No Modbus TCP header: another protocol's identifier or a length no PDU has.

    void append(const QByteArray& bytes) { m_bytes += bytes; }
    /// The next complete message; nothing when more bytes are needed. After a fault the stream is lost:
    /// nobody can tell where the next message begins.
    tl::expected<std::optional<ReceivedFrame>, Fault> next();

    /// What has come of a message that is not complete.
    const QByteArray& incomplete() const { return m_bytes; }
    void clear() { m_bytes.clear(); }

private:
    QByteArray m_bytes;
};

} // namespace lds::modbus

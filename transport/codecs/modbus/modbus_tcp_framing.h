#pragma once

#include <QByteArray>
#include <QtGlobal>

/// The header in front of a PDU over TCP: transaction 2, protocol 2 (0), length 2 (from the unit
/// identifier on), unit 1; all big endian (§5.2.3).
namespace lds::modbus {

inline constexpr int headerSize = 7;
inline constexpr int shortestMessage = 12; ///< Anything shorter is discarded (§5.2.3 notes).
inline constexpr int longestMessage = 270; ///< Anything longer ends the connection (§5.2.3 notes).

struct TcpHeader {
    quint16 transaction = 0;
    quint16 protocol = 0;
    quint16 length = 0; ///< Bytes from the unit identifier on: 1 + PDU.
    quint8 unit = 0;
};

/// Needs at least headerSize bytes in `bytes`.
TcpHeader decodeHeader(const QByteArray& bytes);
/// Header and PDU; `length` is computed.
QByteArray encodeFrame(quint16 transaction, quint8 unit, const QByteArray& pdu);

} // namespace lds::modbus

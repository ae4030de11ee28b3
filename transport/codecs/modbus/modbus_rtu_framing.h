#pragma once

#include <QByteArray>
#include <QtGlobal>
#include <tl/expected.hpp>

/// Frames of Modbus RTU: unit, PDU, CRC with its low byte first (§6.3.2), and how long they and the silence
/// between them take. The silent intervals are those of "Modbus over serial line" V1.02, 2.5.1.1, to which
/// the manual adds nothing.
namespace lds::modbus {

inline constexpr int shortestRtuFrame = 4; ///< Unit, function code, CRC.
inline constexpr int longestRtuFrame = 256;
inline constexpr quint8 broadcastUnit = 0; ///< Obeyed by all, answered by none.
inline constexpr quint8 firstRtuUnit = 1;
inline constexpr quint8 lastRtuUnit = 247;

/// The manual's CRC-16: polynomial 0xA001, beginning with 0xFFFF. Over any number of bytes.
quint16 crc16(const QByteArray& bytes);

struct RtuFrame {
    quint8 unit = 0;
    QByteArray pdu; ///< At least a function code.
};
enum class RtuFrameError : quint8 { TooShort, TooLong, Crc };

/// `pdu`: 1 … 253 bytes.
QByteArray encodeRtuFrame(quint8 unit, const QByteArray& pdu);
/// All bytes between two silences. Says nothing about whether the PDU makes sense.
tl::expected<RtuFrame, RtuFrameError> decodeRtuFrame(const QByteArray& bytes);

/// How fast characters go over a line.
struct RtuRate {
    int bitsPerSecond = 38'400;
    int bitsPerCharacter = 11; ///< Start, eight data, parity or second stop bit, stop bit.
    friend bool operator==(const RtuRate&, const RtuRate&) = default;
};

/// Nanoseconds that `count` characters take, rounded up.
qint64 charactersNs(RtuRate rate, qint64 count);
/// The silence that ends a frame: 3.5 characters, 1.75 ms above 19,200 bps.
qint64 frameSilenceNs(RtuRate rate);
/// The longest pause within a frame: 1.5 characters, 0.75 ms above 19,200 bps.
qint64 longestGapNs(RtuRate rate);

} // namespace lds::modbus

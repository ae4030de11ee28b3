#include "modbus_rtu_framing.h"

#include <array>

namespace lds::modbus {

namespace {

constexpr int crcSize = 2;
constexpr int fastestProportional = 19'200; ///< Above, the silent intervals are fixed.

/// What each value of a byte does to the CRC.
constexpr std::array<quint16, 256> crcTable = [] {
    std::array<quint16, 256> table{};
    for (unsigned byte = 0; byte < table.size(); ++byte) {
        unsigned crc = byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1U ? crc >> 1 ^ 0xA001U : crc >> 1;
        table[byte] = quint16(crc);
    }
    return table;
}();

constexpr qint64 dividedUp(qint64 dividend, qint64 divisor) { return (dividend + divisor - 1) / divisor; }

/// Half characters, since the intervals are 1.5 and 3.5 of them.
qint64 halfCharactersNs(RtuRate rate, qint64 halves)
{
    return dividedUp(halves * rate.bitsPerCharacter * 1'000'000'000LL, 2LL * rate.bitsPerSecond);
}

} // namespace

quint16 crc16(const QByteArray& bytes)
{
    unsigned crc = 0xFFFF;
    for (const char byte : bytes)
        crc = crc >> 8 ^ crcTable[(crc ^ quint8(byte)) & 0xFFU];
    return quint16(crc);
}

QByteArray encodeRtuFrame(quint8 unit, const QByteArray& pdu)
{
    Q_ASSERT(!pdu.isEmpty() && pdu.size() <= longestRtuFrame - 1 - crcSize);
    QByteArray frame;
    frame.reserve(1 + pdu.size() + crcSize);
    frame.append(char(unit)).append(pdu);
    const quint16 crc = crc16(frame);
    return frame.append(char(crc & 0xFF)).append(char(crc >> 8));
}

tl::expected<RtuFrame, RtuFrameError> decodeRtuFrame(const QByteArray& bytes)
{
    if (bytes.size() < shortestRtuFrame)
        return tl::unexpected(RtuFrameError::TooShort);
    if (bytes.size() > longestRtuFrame)
        return tl::unexpected(RtuFrameError::TooLong);
    const qsizetype end = bytes.size() - crcSize;
    const auto crc = quint16(quint8(bytes.at(end)) | quint8(bytes.at(end + 1)) << 8);
    if (crc != crc16(bytes.first(end)))
        return tl::unexpected(RtuFrameError::Crc);
    return RtuFrame{quint8(bytes.at(0)), bytes.mid(1, end - 1)};
}

qint64 charactersNs(RtuRate rate, qint64 count) { return halfCharactersNs(rate, 2 * count); }

qint64 frameSilenceNs(RtuRate rate)
{
    return rate.bitsPerSecond > fastestProportional ? 1'750'000 : halfCharactersNs(rate, 7);
}

qint64 longestGapNs(RtuRate rate)
{
    return rate.bitsPerSecond > fastestProportional ? 750'000 : halfCharactersNs(rate, 3);
}

} // namespace lds::modbus

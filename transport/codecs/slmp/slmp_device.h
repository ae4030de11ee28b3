#pragma once

#include "slmp_complete_code.h"

#include <optional>
#include <QByteArray>
#include <QList>
#include <QtGlobal>

/// Devices as requests name them: number 3 bytes, code 1 byte (§5.4.3, "List of Supported Device Codes").
/// Which numbers exist is not the codec's matter: §5.4.4 and §5.4.5 are in the catalog.
namespace lds::slmp {

class Reader;
class Writer;

enum class DeviceCode : quint8 {
    DataRegister = 0xa8, ///< 16-bit words, in pairs as double words; never single bits.
    Output = 0x9d,       ///< Single bits only.
};

struct Device {
    DeviceCode code = DeviceCode::DataRegister;
    quint32 number = 0;

    bool operator==(const Device&) const = default;
};

enum class AccessUnit : quint8 { Word, Bit, DoubleWord };

inline constexpr int maximumPoints = 144;                ///< In one request, words and double words together.
inline constexpr quint32 maximumDeviceNumber = 0xffffff; ///< What three bytes can name.
inline constexpr int deviceSize = 4;                     ///< Bytes on the wire.

/// Subcommands of the four commands for devices: 0 for words and double words, 1 for bits.
inline constexpr quint16 wordSubcommand = 0x0000;
inline constexpr quint16 bitSubcommand = 0x0001;

/// CEE1H above 144 points, C05CH for none at all.
std::optional<CompleteCode> checkPoints(int points);
/// C05CH for a device code that the table lacks, a unit that it does not allow for the code, or numbers
/// that end beyond what three bytes can name.
std::optional<CompleteCode> checkDevices(const Device& first, int points, AccessUnit unit);

/// Any code, checked or not.
Device readDevice(Reader& reader);
void writeDevice(Writer& writer, const Device& device);

/// Two bits a byte, the first in the upper half.
QByteArray packBits(const QList<bool>& bits);
constexpr qsizetype packedSize(qsizetype bits) { return (bits + 1) / 2; }
/// `count` bits out of packedSize(count) bytes; nothing when the size differs, a half byte is neither 0
/// nor 1, or the unused last half is not 0.
std::optional<QList<bool>> unpackBits(const QByteArray& bytes, qsizetype count);

QByteArray packWords(const QList<quint16>& words);
/// Needs an even number of bytes.
QList<quint16> unpackWords(const QByteArray& bytes);

/// The device number holds the lower bytes, the next one the higher bytes (§5.4.3).
constexpr quint32 toDoubleWord(quint16 first, quint16 second) { return (quint32(second) << 16) | first; }
constexpr quint16 lowerWord(quint32 doubleWord) { return quint16(doubleWord & 0xffff); }
constexpr quint16 higherWord(quint32 doubleWord) { return quint16(doubleWord >> 16); }

} // namespace lds::slmp

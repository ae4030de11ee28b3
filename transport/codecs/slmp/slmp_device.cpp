#include "slmp_device.h"

#include "slmp_reader.h"
#include "slmp_writer.h"

namespace lds::slmp {

namespace {

bool isAllowed(DeviceCode code, AccessUnit unit)
{
    switch (code) {
    case DeviceCode::DataRegister:
        return unit != AccessUnit::Bit;
    case DeviceCode::Output:
        return unit == AccessUnit::Bit;
    }
    return false;
}

} // namespace

std::optional<CompleteCode> checkPoints(int points)
{
    if (points > maximumPoints)
        return CompleteCode::RequestTooLarge;
    if (points < 1)
        return CompleteCode::Request;
    return std::nullopt;
}

std::optional<CompleteCode> checkDevices(const Device& first, int points, AccessUnit unit)
{
    const auto devices = quint32(unit == AccessUnit::DoubleWord ? 2 * points : points);
    if (!isAllowed(first.code, unit) || first.number + devices - 1 > maximumDeviceNumber)
        return CompleteCode::Request;
    return std::nullopt;
}

Device readDevice(Reader& reader)
{
    const quint32 number = reader.u24();
    return {DeviceCode(reader.u8()), number};
}

void writeDevice(Writer& writer, const Device& device) { writer.u24(device.number).u8(quint8(device.code)); }

QByteArray packBits(const QList<bool>& bits)
{
    QByteArray bytes(packedSize(bits.size()), '\0');
    for (qsizetype i = 0; i < bits.size(); ++i) {
        if (bits.at(i))
            bytes[i / 2] = char(quint8(bytes.at(i / 2)) | (i % 2 == 0 ? 0x10U : 0x01U));
    }
    return bytes;
}

std::optional<QList<bool>> unpackBits(const QByteArray& bytes, qsizetype count)
{
    if (bytes.size() != packedSize(count))
        return std::nullopt;
    QList<bool> bits;
    bits.reserve(count);
    for (qsizetype half = 0; half < 2 * bytes.size(); ++half) {
        const auto byte = quint8(bytes.at(half / 2));
        const int value = half % 2 == 0 ? byte >> 4 : byte & 0x0f;
        if (value > (half < count ? 1 : 0))
            return std::nullopt;
        if (half < count)
            bits.append(value == 1);
    }
    return bits;
}

QByteArray packWords(const QList<quint16>& words)
{
    Writer writer;
    for (const quint16 word : words)
        writer.u16(word);
    return writer.result();
}

QList<quint16> unpackWords(const QByteArray& bytes)
{
    QList<quint16> words;
    words.reserve(bytes.size() / 2);
    for (Reader reader(bytes); reader.left() > 1;)
        words.append(reader.u16());
    return words;
}

} // namespace lds::slmp

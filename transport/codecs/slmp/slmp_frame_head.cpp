#include "slmp_frame_head.h"

namespace lds::slmp {

namespace {

struct Subheader {
    FrameType type;
    quint8 request;
    quint8 response;
};

// The second byte is 00 in all of them.
constexpr Subheader subheaders[] = {
    {FrameType::St, 0x50, 0xd0},
    {FrameType::Mt, 0x54, 0xd4},
    {FrameType::Lmt, 0x68, 0xe8},
};

quint8 firstByte(const Subheader& subheader, Direction direction)
{
    return direction == Direction::Request ? subheader.request : subheader.response;
}

std::optional<FrameType> readSubheader(Reader& reader, Direction direction)
{
    const quint8 first = reader.u8();
    const quint8 second = reader.u8();
    if (reader.failed() || second != 0)
        return std::nullopt;
    for (const Subheader& subheader : subheaders) {
        if (first == firstByte(subheader, direction))
            return subheader.type;
    }
    return std::nullopt;
}

} // namespace

std::optional<FrameHead> readHead(Reader& reader, Direction direction)
{
    const auto type = readSubheader(reader, direction);
    if (!type)
        return std::nullopt;
    FrameHead head;
    head.type = *type;
    quint32 reserved = 0;
    if (*type != FrameType::St) {
        head.serial = reader.u16();
        reserved |= reader.u16();
    }
    head.route.network = reader.u8();
    head.route.node = reader.u8();
    head.route.processor = reader.u16();
    reserved |= *type == FrameType::Lmt ? reader.u32() : reader.u8();
    head.length = reader.u16();
    head.reservedIsZero = reserved == 0;
    if (reader.failed())
        return std::nullopt;
    return head;
}

void writeHead(Writer& writer, Direction direction, const FrameHead& head)
{
    for (const Subheader& subheader : subheaders) {
        if (subheader.type == head.type)
            writer.u8(firstByte(subheader, direction)).u8(0);
    }
    if (head.type != FrameType::St)
        writer.u16(head.serial).u16(0);
    writer.u8(head.route.network).u8(head.route.node).u16(head.route.processor);
    if (head.type == FrameType::Lmt)
        writer.u32(0);
    else
        writer.u8(0);
    writer.u16(head.length);
}

Division readDivision(Reader& reader)
{
    Division division;
    division.reservedIsZero = reader.u8() == 0;
    division.dataId = reader.u8();
    division.divided = reader.u32() != 0;
    return division;
}

void writeDivision(Writer& writer, quint8 dataId) { writer.u8(0).u8(dataId).u32(0); }

} // namespace lds::slmp

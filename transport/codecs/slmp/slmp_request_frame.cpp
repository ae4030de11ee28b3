#include "slmp_request_frame.h"

#include "slmp_frame_head.h"

namespace lds::slmp {

namespace {

constexpr int timerAndCommandSize = 6; ///< Timer 2, command 2, subcommand 2.
constexpr int divisionSize = 6;

int headBody(FrameType type) { return timerAndCommandSize + (type == FrameType::Lmt ? divisionSize : 0); }

} // namespace

QByteArray encodeRequestFrame(const RequestFrame& frame)
{
    Writer writer;
    const auto length = quint16(headBody(frame.type) + frame.message.data.size());
    writeHead(writer, Direction::Request, {frame.type, frame.serial, frame.route, length});
    writer.u16(frame.timer).u16(quint16(frame.message.command)).u16(frame.message.subcommand);
    if (frame.type == FrameType::Lmt)
        writeDivision(writer, frame.dataId);
    return writer.bytes(frame.message.data).result();
}

tl::expected<RequestFrame, RequestFailure> decodeRequestFrame(const QByteArray& datagram)
{
    Reader reader(datagram);
    const auto head = readHead(reader, Direction::Request);
    if (!head)
        return tl::unexpected(RequestFailure{});
    const qsizetype following = reader.left();
    RequestFrame frame{head->type, head->serial, head->route, reader.u16(), 0, {}};
    frame.message.command = Command(reader.u16());
    frame.message.subcommand = reader.u16();
    const Division division = frame.type == FrameType::Lmt ? readDivision(reader) : Division{};
    frame.dataId = division.dataId;
    if (reader.failed())
        return tl::unexpected(RequestFailure{});

    const auto refuse = [&frame](CompleteCode code) { return tl::unexpected(RequestFailure{code, frame}); };
    if (datagram.size() > maximumMessageSize)
        return refuse(CompleteCode::RequestTooLarge);
    frame.message.data = reader.rest();
    if (head->length != following)
        return refuse(CompleteCode::RequestDataSize);
    if (division.divided)
        return refuse(CompleteCode::Divided);
    if (!head->reservedIsZero || !division.reservedIsZero)
        return refuse(CompleteCode::Request);
    return frame;
}

} // namespace lds::slmp

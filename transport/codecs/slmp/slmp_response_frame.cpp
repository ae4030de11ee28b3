#include "slmp_response_frame.h"

#include "slmp_frame_head.h"

namespace lds::slmp {

namespace {

constexpr int completeCodeSize = 2;
constexpr int commandAndDivisionSize = 10; ///< LMT: command 2, subcommand 2, division 6.

QByteArray encodeErrorInformation(const ErrorInformation& information)
{
    Writer writer;
    writer.u8(information.route.network).u8(information.route.node).u16(information.route.processor);
    writer.u8(0).u16(quint16(information.command)).u16(information.subcommand);
    return writer.result();
}

tl::expected<ErrorInformation, ResponseError> decodeErrorInformation(const QByteArray& bytes)
{
    Reader reader(bytes);
    ErrorInformation information;
    information.route.network = reader.u8();
    information.route.node = reader.u8();
    information.route.processor = reader.u16();
    const quint8 reserved = reader.u8();
    information.command = Command(reader.u16());
    information.subcommand = reader.u16();
    if (!reader.finished())
        return tl::unexpected(ResponseError::Length);
    if (reserved != 0)
        return tl::unexpected(ResponseError::Reserved);
    return information;
}

ResponseFrame answerTo(const RequestFrame& request, CompleteCode code)
{
    ResponseFrame frame{request.type, request.serial, request.route, code};
    if (request.type == FrameType::Lmt) {
        frame.command = request.message.command;
        frame.subcommand = request.message.subcommand;
        frame.dataId = request.dataId;
    }
    return frame;
}

bool answers(const ResponseFrame& response, const RequestFrame& request)
{
    const auto sameCommand = [&request](Command command, quint16 subcommand) {
        return command == request.message.command && subcommand == request.message.subcommand;
    };
    if (response.type != request.type || response.route != request.route)
        return false;
    if (request.type != FrameType::St && response.serial != request.serial)
        return false;
    if (request.type == FrameType::Lmt && !sameCommand(response.command, response.subcommand))
        return false;
    const auto& refused = response.errorInformation;
    return !refused || sameCommand(refused->command, refused->subcommand);
}

} // namespace

QByteArray encodeResponseFrame(const ResponseFrame& frame)
{
    const bool lmt = frame.type == FrameType::Lmt;
    const QByteArray data =
        frame.errorInformation ? encodeErrorInformation(*frame.errorInformation) : frame.data;
    const auto length = quint16(completeCodeSize + (lmt ? commandAndDivisionSize : 0) + data.size());
    Writer writer;
    writeHead(writer, Direction::Response, {frame.type, frame.serial, frame.route, length});
    writer.u16(quint16(frame.completeCode));
    if (lmt) {
        writer.u16(quint16(frame.command)).u16(frame.subcommand);
        writeDivision(writer, frame.dataId);
    }
    return writer.bytes(data).result();
}

QByteArray encodeAnswer(const RequestFrame& request, const QByteArray& data)
{
    ResponseFrame frame = answerTo(request, CompleteCode::Success);
    frame.data = data;
    const QByteArray datagram = encodeResponseFrame(frame);
    if (datagram.size() > maximumMessageSize)
        return encodeErrorAnswer(request, CompleteCode::ResponseTooLarge);
    return datagram;
}

QByteArray encodeErrorAnswer(const RequestFrame& request, CompleteCode code)
{
    ResponseFrame frame = answerTo(request, code);
    if (request.type != FrameType::Lmt)
        frame.errorInformation = {request.route, request.message.command, request.message.subcommand};
    return encodeResponseFrame(frame);
}

tl::expected<ResponseFrame, ResponseError> decodeResponseFrame(const QByteArray& datagram)
{
    Reader reader(datagram);
    const auto head = readHead(reader, Direction::Response);
    if (!head)
        return tl::unexpected(ResponseError::NoResponse);
    const qsizetype following = reader.left();
    ResponseFrame frame{head->type, head->serial, head->route, CompleteCode(reader.u16())};
    Division division;
    if (frame.type == FrameType::Lmt) {
        frame.command = Command(reader.u16());
        frame.subcommand = reader.u16();
        division = readDivision(reader);
        frame.dataId = division.dataId;
    }
    if (reader.failed())
        return tl::unexpected(ResponseError::NoResponse);
    if (datagram.size() > maximumMessageSize || head->length != following)
        return tl::unexpected(ResponseError::Length);
    if (division.divided)
        return tl::unexpected(ResponseError::Divided);
    if (!head->reservedIsZero || !division.reservedIsZero)
        return tl::unexpected(ResponseError::Reserved);

    frame.data = reader.rest();
    if (frame.completeCode == CompleteCode::Success)
        return frame;
    if (frame.type == FrameType::Lmt && frame.data.isEmpty())
        return frame;
    const auto information = decodeErrorInformation(frame.data);
    if (!information)
        return tl::unexpected(information.error());
    frame.errorInformation = *information;
    frame.data.clear();
    return frame;
}

tl::expected<QByteArray, ResponseFailure> decodeAnswer(const RequestFrame& request,
                                                       const QByteArray& datagram)
{
    const auto response = decodeResponseFrame(datagram);
    if (!response)
        return tl::unexpected(ResponseFailure{response.error()});
    if (!answers(*response, request))
        return tl::unexpected(ResponseFailure{ResponseError::AnotherAnswer});
    if (response->completeCode != CompleteCode::Success)
        return tl::unexpected(ResponseFailure{ResponseError::Refused, response->completeCode});
    return response->data;
}

} // namespace lds::slmp

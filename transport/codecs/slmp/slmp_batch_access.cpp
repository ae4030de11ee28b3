#include "slmp_batch_access.h"

#include "slmp_reader.h"
#include "slmp_writer.h"

namespace lds::slmp {

namespace {

quint16 subcommandOf(AccessUnit unit) { return unit == AccessUnit::Bit ? bitSubcommand : wordSubcommand; }

Message encodeStart(Command command, AccessUnit unit, const Device& start, quint16 points)
{
    Writer writer;
    writeDevice(writer, start);
    writer.u16(points);
    return {command, subcommandOf(unit), writer.result()};
}

/// What Read and Write have in common; the number of bytes after it is the caller's to check.
tl::expected<ReadRequest, CompleteCode> decodeStart(const Message& message, Reader& reader)
{
    if (message.subcommand != wordSubcommand && message.subcommand != bitSubcommand)
        return tl::unexpected(CompleteCode::Command);
    ReadRequest request;
    request.unit = message.subcommand == bitSubcommand ? AccessUnit::Bit : AccessUnit::Word;
    request.start = readDevice(reader);
    request.points = reader.u16();
    if (reader.failed())
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (const auto refused = checkPoints(request.points))
        return tl::unexpected(*refused);
    return request;
}

qsizetype valuesSize(const ReadRequest& request)
{
    return request.unit == AccessUnit::Bit ? packedSize(request.points) : 2 * qsizetype(request.points);
}

} // namespace

Message encodeRequest(const ReadRequest& request)
{
    return encodeStart(Command::Read, request.unit, request.start, request.points);
}

tl::expected<ReadRequest, CompleteCode> decodeReadRequest(const Message& message)
{
    Reader reader(message.data);
    const auto request = decodeStart(message, reader);
    if (!request)
        return request;
    if (!reader.finished())
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (const auto refused = checkDevices(request->start, request->points, request->unit))
        return tl::unexpected(*refused);
    return request;
}

QByteArray encodeResponse(const ReadRequest& request, const ReadResponse& response)
{
    return request.unit == AccessUnit::Bit ? packBits(response.bits) : packWords(response.words);
}

tl::expected<ReadResponse, ResponseFailure> decodeReadResponse(const ReadRequest& request,
                                                               const QByteArray& data)
{
    if (data.size() != valuesSize(request))
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    if (request.unit != AccessUnit::Bit)
        return ReadResponse{unpackWords(data), {}};
    const auto bits = unpackBits(data, request.points);
    if (!bits)
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    return ReadResponse{{}, *bits};
}

Message encodeRequest(const WriteRequest& request)
{
    const bool bits = request.unit == AccessUnit::Bit;
    const auto points = quint16(bits ? request.bits.size() : request.words.size());
    Message message = encodeStart(Command::Write, request.unit, request.start, points);
    message.data += bits ? packBits(request.bits) : packWords(request.words);
    return message;
}

tl::expected<WriteRequest, CompleteCode> decodeWriteRequest(const Message& message)
{
    Reader reader(message.data);
    const auto start = decodeStart(message, reader);
    if (!start)
        return tl::unexpected(start.error());
    if (reader.left() != valuesSize(*start))
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (const auto refused = checkDevices(start->start, start->points, start->unit))
        return tl::unexpected(*refused);
    if (start->unit == AccessUnit::Word)
        return WriteRequest{start->unit, start->start, unpackWords(reader.rest()), {}};
    const auto bits = unpackBits(reader.rest(), start->points);
    if (!bits)
        return tl::unexpected(CompleteCode::Request);
    return WriteRequest{start->unit, start->start, {}, *bits};
}

tl::expected<void, ResponseFailure> decodeEmptyResponse(const QByteArray& data)
{
    if (!data.isEmpty())
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    return {};
}

} // namespace lds::slmp

#include "slmp_remote_control.h"

#include "slmp_reader.h"
#include "slmp_writer.h"

#include <algorithm>

namespace lds::slmp {

namespace {

constexpr quint16 onlySubcommand = 0x0000;
constexpr quint16 stopMode = 0x0001;

bool isPrintable(char character) { return character >= 0x20 && character <= 0x7e; }

void dropFilling(QByteArray& name)
{
    while (name.endsWith(' ') || name.endsWith('\0'))
        name.chop(1);
}

} // namespace

Message encodeRequest(const RemoteRunRequest& request)
{
    Writer writer;
    writer.u16(request.mode).u8(request.clearMode).u8(0);
    return {Command::RemoteRun, onlySubcommand, writer.result()};
}

tl::expected<RemoteRunRequest, CompleteCode> decodeRemoteRunRequest(const Message& message)
{
    if (message.subcommand != onlySubcommand)
        return tl::unexpected(CompleteCode::Command);
    Reader reader(message.data);
    const RemoteRunRequest request{reader.u16(), reader.u8()};
    const quint8 fixed = reader.u8();
    if (!reader.finished())
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (fixed != 0)
        return tl::unexpected(CompleteCode::Request);
    return request;
}

Message encodeRequest(const RemoteStopRequest&)
{
    return {Command::RemoteStop, onlySubcommand, Writer().u16(stopMode).result()};
}

tl::expected<RemoteStopRequest, CompleteCode> decodeRemoteStopRequest(const Message& message)
{
    if (message.subcommand != onlySubcommand)
        return tl::unexpected(CompleteCode::Command);
    Reader reader(message.data);
    const quint16 mode = reader.u16();
    if (!reader.finished())
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (mode != stopMode)
        return tl::unexpected(CompleteCode::Request);
    return RemoteStopRequest{};
}

Message encodeRequest(const ReadTypeNameRequest&) { return {Command::ReadTypeName, onlySubcommand, {}}; }

tl::expected<ReadTypeNameRequest, CompleteCode> decodeReadTypeNameRequest(const Message& message)
{
    if (message.subcommand != onlySubcommand)
        return tl::unexpected(CompleteCode::Command);
    if (!message.data.isEmpty())
        return tl::unexpected(CompleteCode::RequestDataSize);
    return ReadTypeNameRequest{};
}

QByteArray encodeResponse(const ReadTypeNameResponse& response)
{
    const QByteArray name = response.name.toLatin1().leftJustified(typeNameSize, ' ', true);
    return Writer().bytes(name).u16(response.modelCode).result();
}

tl::expected<ReadTypeNameResponse, ResponseFailure> decodeReadTypeNameResponse(const QByteArray& data)
{
    Reader reader(data);
    QByteArray name = reader.bytes(typeNameSize);
    const quint16 modelCode = reader.u16();
    dropFilling(name);
    if (!reader.finished() || name.isEmpty() || !std::all_of(name.cbegin(), name.cend(), isPrintable))
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    return ReadTypeNameResponse{QString::fromLatin1(name), modelCode};
}

} // namespace lds::slmp

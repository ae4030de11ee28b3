#include "slmp_node_search.h"

#include "slmp_reader.h"
#include "slmp_writer.h"

namespace lds::slmp {

namespace {

constexpr int maximumHostName = 255; ///< What the length byte can say.

} // namespace

Message encodeRequest(const NodeSearchRequest& request)
{
    Writer writer;
    writeHardwareAddress(writer, request.client.mac);
    writer.u8(ipv4Size).u32(request.client.ip);
    return {Command::NodeSearch, 0, writer.result()};
}

tl::expected<NodeSearchRequest, std::optional<CompleteCode>> decodeNodeSearchRequest(const Message& message)
{
    if (message.subcommand != 0)
        return tl::unexpected(CompleteCode::Command);
    Reader reader(message.data);
    NodeSearchRequest request;
    request.client.mac = readHardwareAddress(reader);
    const quint8 addressSize = reader.u8();
    if (!reader.failed() && addressSize != ipv4Size)
        return tl::unexpected(std::nullopt);
    request.client.ip = reader.u32();
    if (!reader.finished())
        return tl::unexpected(CompleteCode::RequestDataSize);
    return request;
}

QByteArray encodeResponse(const NodeSearchResponse& response)
{
    const QByteArray hostName = response.hostName.left(maximumHostName);
    Writer writer;
    writeHardwareAddress(writer, response.client.mac);
    writer.u8(ipv4Size).u32(response.client.ip);
    writeHardwareAddress(writer, response.mac);
    writer.u8(ipv4Size).u32(response.ip).u32(response.subnetMask).u32(response.defaultGateway);
    writer.u8(quint8(hostName.size())).bytes(hostName);
    writer.u16(response.vendorCode).u32(response.modelCode).u16(response.version);
    writer.u8(ipv4Size).u32(response.targetIp).u16(response.targetPort);
    writer.u16(response.status).u16(response.port).u8(response.protocol);
    return writer.result();
}

tl::expected<NodeSearchResponse, ResponseFailure> decodeNodeSearchResponse(const NodeSearchRequest& request,
                                                                           const QByteArray& data)
{
    Reader reader(data);
    NodeSearchResponse response;
    response.client.mac = readHardwareAddress(reader);
    const quint8 clientSize = reader.u8();
    response.client.ip = reader.u32();
    response.mac = readHardwareAddress(reader);
    const quint8 addressSize = reader.u8();
    response.ip = reader.u32();
    response.subnetMask = reader.u32();
    response.defaultGateway = reader.u32();
    response.hostName = reader.bytes(reader.u8());
    response.vendorCode = reader.u16();
    response.modelCode = reader.u32();
    response.version = reader.u16();
    const quint8 targetSize = reader.u8();
    response.targetIp = reader.u32();
    response.targetPort = reader.u16();
    response.status = reader.u16();
    response.port = reader.u16();
    response.protocol = reader.u8();
    const bool allIpv4 = clientSize == ipv4Size && addressSize == ipv4Size && targetSize == ipv4Size;
    if (!reader.finished() || !allIpv4)
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    if (response.client != request.client)
        return tl::unexpected(ResponseFailure{ResponseError::AnotherAnswer});
    return response;
}

} // namespace lds::slmp

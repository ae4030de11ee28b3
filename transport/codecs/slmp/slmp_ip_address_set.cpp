#include "slmp_ip_address_set.h"

#include "slmp_reader.h"
#include "slmp_writer.h"

namespace lds::slmp {

Message encodeRequest(const IpAddressSetRequest& request)
{
    Writer writer;
    writeHardwareAddress(writer, request.client.mac);
    writer.u8(ipv4Size).u32(request.client.ip);
    writeHardwareAddress(writer, request.mac);
    writer.u8(ipv4Size).u32(request.ip).u32(request.subnetMask).u32(request.defaultGateway);
    writer.u8(quint8(request.hostName.size())).bytes(request.hostName);
    writer.u8(ipv4Size).u32(request.targetIp).u16(request.targetPort).u8(request.protocol);
    return {Command::IpAddressSet, 0, writer.result()};
}

tl::expected<IpAddressSetRequest, CompleteCode> decodeIpAddressSetRequest(const Message& message)
{
    if (message.subcommand != 0)
        return tl::unexpected(CompleteCode::Command);
    Reader reader(message.data);
    IpAddressSetRequest request;
    // A size that is not IPv4's moves all that follows, so it is judged before the size of the message.
    const auto isOtherSize = [&reader](quint8 size) { return !reader.failed() && size != ipv4Size; };
    request.client.mac = readHardwareAddress(reader);
    if (isOtherSize(reader.u8()))
        return tl::unexpected(CompleteCode::Request);
    request.client.ip = reader.u32();
    request.mac = readHardwareAddress(reader);
    if (isOtherSize(reader.u8()))
        return tl::unexpected(CompleteCode::Request);
    request.ip = reader.u32();
    request.subnetMask = reader.u32();
    request.defaultGateway = reader.u32();
    const quint8 hostNameSize = reader.u8();
    if (hostNameSize > maximumHostNameToSet)
        return tl::unexpected(CompleteCode::Request);
    request.hostName = reader.bytes(hostNameSize);
    if (isOtherSize(reader.u8()))
        return tl::unexpected(CompleteCode::Request);
    request.targetIp = reader.u32();
    request.targetPort = reader.u16();
    request.protocol = reader.u8();
    if (!reader.finished())
        return tl::unexpected(CompleteCode::RequestDataSize);
    if (request.protocol != protocolUdp)
        return tl::unexpected(CompleteCode::IpSetting);
    return request;
}

std::optional<HardwareAddress> addressedSensor(const Message& ipAddressSet)
{
    Reader reader(ipAddressSet.data);
    readHardwareAddress(reader);
    const quint8 addressSize = reader.u8();
    if (addressSize != ipv4Size && addressSize != ipv6Size)
        return std::nullopt;
    reader.skip(addressSize);
    const HardwareAddress address = readHardwareAddress(reader);
    if (reader.failed())
        return std::nullopt;
    return address;
}

QByteArray encodeResponse(const IpAddressSetResponse& response)
{
    Writer writer;
    writeHardwareAddress(writer, response.client);
    return writer.result();
}

tl::expected<IpAddressSetResponse, ResponseFailure>
decodeIpAddressSetResponse(const IpAddressSetRequest& request, const QByteArray& data)
{
    Reader reader(data);
    const IpAddressSetResponse response{readHardwareAddress(reader)};
    if (!reader.finished())
        return tl::unexpected(ResponseFailure{ResponseError::Data});
    if (response.client != request.client.mac)
        return tl::unexpected(ResponseFailure{ResponseError::AnotherAnswer});
    return response;
}

} // namespace lds::slmp

#include "slmp_server_request.h"

namespace lds::slmp {

namespace {

using Decoded = tl::expected<ServerRequest, std::optional<CompleteCode>>;

template <typename Request>
Decoded widen(const tl::expected<Request, CompleteCode>& decoded)
{
    if (!decoded)
        return tl::unexpected(std::optional(decoded.error()));
    return ServerRequest(*decoded);
}

Decoded decodeNodeSearch(const Message& message)
{
    const auto decoded = decodeNodeSearchRequest(message);
    if (!decoded)
        return tl::unexpected(decoded.error());
    return ServerRequest(*decoded);
}

Decoded decodeCommand(const Message& message)
{
    switch (message.command) {
    case Command::Read:
        return widen(decodeReadRequest(message));
    case Command::Write:
        return widen(decodeWriteRequest(message));
    case Command::ReadRandom:
        return widen(decodeReadRandomRequest(message));
    case Command::WriteRandom:
        return widen(decodeWriteRandomRequest(message));
    case Command::RemoteRun:
        return widen(decodeRemoteRunRequest(message));
    case Command::RemoteStop:
        return widen(decodeRemoteStopRequest(message));
    case Command::ReadTypeName:
        return widen(decodeReadTypeNameRequest(message));
    case Command::SelfTest:
        return widen(decodeSelfTestRequest(message));
    case Command::NodeSearch:
        return decodeNodeSearch(message);
    case Command::IpAddressSet:
        return widen(decodeIpAddressSetRequest(message));
    case Command::DeviceInfoCompare:
        return widen(decodeDeviceInfoCompareRequest(message));
    }
    return tl::unexpected(CompleteCode::Command);
}

/// Note 3 of the table: answered with C05CH. What note 2 leaves unanswered is staysSilent's.
bool isSupported(Command command, FrameType type)
{
    switch (command) {
    case Command::IpAddressSet:
        return type != FrameType::St;
    case Command::DeviceInfoCompare:
        return type == FrameType::Mt;
    default:
        return true;
    }
}

bool staysSilent(const RequestFrame& frame, const Station& station)
{
    const Message& message = frame.message;
    if (message.command == Command::NodeSearch)
        return frame.type != FrameType::Mt; // table, note 2
    if (message.command != Command::IpAddressSet || !isSupported(message.command, frame.type))
        return false;
    const auto addressed = addressedSensor(message);
    return addressed && *addressed != station.mac;
}

} // namespace

bool isAddressedTo(const Station& station, FrameType type, const Route& route)
{
    if (route == localStation)
        return true;
    return type != FrameType::Lmt && route == Route{station.network, station.node, defaultProcessor};
}

tl::expected<AcceptedRequest, RequestFailure> decodeServerRequest(const QByteArray& datagram,
                                                                  const Station& station)
{
    const auto frame = decodeRequestFrame(datagram);
    const RequestFrame& asked = frame ? *frame : frame.error().request;
    const auto refuse = [&asked](std::optional<CompleteCode> code) {
        return tl::unexpected(RequestFailure{code, asked});
    };
    if (!frame && !frame.error().answer)
        return refuse(std::nullopt);
    if (staysSilent(asked, station))
        return refuse(std::nullopt);
    if (!frame)
        return refuse(frame.error().answer);
    if (!isAddressedTo(station, asked.type, asked.route))
        return refuse(CompleteCode::Request);
    if (!isSupported(asked.message.command, asked.type))
        return refuse(CompleteCode::Request);
    const Decoded request = decodeCommand(asked.message);
    if (!request)
        return refuse(request.error());
    return AcceptedRequest{asked, *request};
}

} // namespace lds::slmp

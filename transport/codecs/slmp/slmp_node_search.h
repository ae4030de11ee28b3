#pragma once

#include "slmp_node_address.h"
#include "slmp_response_frame.h"

/// Node Search (0E30H), MT only: broadcast by a client, answered by every sensor with its identity.
namespace lds::slmp {

/// Data: MAC 6, address size 1 (4), IP 4.
struct NodeSearchRequest {
    ClientAddress client;

    bool operator==(const NodeSearchRequest&) const = default;
};

/// Data: client MAC 6, size 1, IP 4; MAC 6, size 1, IP 4, mask 4, gateway 4; host-name length 1 and name;
/// vendor 2, model 4, version 2; target size 1, IP 4, port 2; status 2; port 2, protocol 1.
struct NodeSearchResponse {
    ClientAddress client; ///< Copied from the request.
    HardwareAddress mac;
    quint32 ip = 0;
    quint32 subnetMask = 0;
    quint32 defaultGateway = 0;
    QByteArray hostName = {}; ///< At most 255 bytes; a longer one is cut.
    quint16 vendorCode = 0;
    quint32 modelCode = 0;
    quint16 version = 0;
    quint32 targetIp = noTargetIp;
    quint16 targetPort = noTargetPort;
    quint16 status = 0; ///< 0: normal.
    quint16 port = defaultServerPort;
    quint8 protocol = protocolUdp;

    bool operator==(const NodeSearchResponse&) const = default;
};

Message encodeRequest(const NodeSearchRequest& request);
/// C059H subcommand, C061H size. Nothing instead of a code means no response: an IPv6 address, or an
/// address size that is neither (§5.4.3 notes).
tl::expected<NodeSearchRequest, std::optional<CompleteCode>> decodeNodeSearchRequest(const Message& message);
QByteArray encodeResponse(const NodeSearchResponse& response);
/// AnotherAnswer when it answers another client.
tl::expected<NodeSearchResponse, ResponseFailure> decodeNodeSearchResponse(const NodeSearchRequest& request,
                                                                           const QByteArray& data);

} // namespace lds::slmp

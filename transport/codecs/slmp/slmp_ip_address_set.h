#pragma once

#include "slmp_node_address.h"
#include "slmp_response_frame.h"

/// IP Address Set (0E31H): broadcast to give the sensor with the named MAC address its IP address. The
/// others stay silent.
namespace lds::slmp {

inline constexpr int maximumHostNameToSet = 32; ///< Bytes; C05CH above (§5.4.3).

/// Data: client MAC 6, address size 1 (4), IP 4; server MAC 6, size 1, new IP 4, mask 4, gateway 4;
/// host-name length 1 and name; target size 1, IP 4, port 2; protocol 1.
struct IpAddressSetRequest {
    ClientAddress client;
    HardwareAddress mac; ///< Of the sensor that is meant.
    quint32 ip = 0;
    quint32 subnetMask = 0;
    quint32 defaultGateway = 0;
    QByteArray hostName = {};
    quint32 targetIp = noTargetIp;
    quint16 targetPort = noTargetPort;
    quint8 protocol = protocolUdp;

    bool operator==(const IpAddressSetRequest&) const = default;
};

Message encodeRequest(const IpAddressSetRequest& request);
/// C059H subcommand; C05CH for an address size other than IPv4's and a host name above 32 bytes; C061H
/// size; CF20H for a protocol other than UDP. The combination of addresses is the sensor's to judge (§5.4.1).
tl::expected<IpAddressSetRequest, CompleteCode> decodeIpAddressSetRequest(const Message& message);
/// Whom a request is for, even one that decodeIpAddressSetRequest refuses, so that only the sensor it
/// names answers; nothing when it names none.
std::optional<HardwareAddress> addressedSensor(const Message& ipAddressSet);

/// Data: client MAC 6.
struct IpAddressSetResponse {
    HardwareAddress client;

    bool operator==(const IpAddressSetResponse&) const = default;
};

QByteArray encodeResponse(const IpAddressSetResponse& response);
/// AnotherAnswer when it answers another client.
tl::expected<IpAddressSetResponse, ResponseFailure>
decodeIpAddressSetResponse(const IpAddressSetRequest& request, const QByteArray& data);

} // namespace lds::slmp

#pragma once

#include <array>
#include <QtGlobal>

/// How Node Search and IP Address Set name nodes. MAC and IP addresses are byte-reversed on the wire.
namespace lds::slmp {

class Reader;
class Writer;

struct HardwareAddress {
    std::array<quint8, 6> octets{}; ///< As people write it: the vendor's octets first.

    bool operator==(const HardwareAddress&) const = default;
};

/// IPv4 addresses are numbers in host order: 192.168.1.6 is 0xc0a80106.
inline constexpr quint8 ipv4Size = 4;
inline constexpr quint8 ipv6Size = 16; ///< Recognised, never supported (§5.4.3 notes).
inline constexpr quint8 protocolUdp = 1;
inline constexpr quint32 noTargetIp = 0xffffffff; ///< The partner's address when there is none.
inline constexpr quint16 noTargetPort = 0xffff;

/// Who asks, and in a response who asked.
struct ClientAddress {
    HardwareAddress mac;
    quint32 ip = 0;

    bool operator==(const ClientAddress&) const = default;
};

HardwareAddress readHardwareAddress(Reader& reader);
void writeHardwareAddress(Writer& writer, const HardwareAddress& address);

} // namespace lds::slmp

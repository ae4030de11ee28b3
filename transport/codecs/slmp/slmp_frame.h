#pragma once

#include <QByteArray>
#include <QtGlobal>

/// What requests and responses of SLMP have in common (§5.4.2): binary frames over UDP, one a datagram.
namespace lds::slmp {

/// The subheader tells them apart. MT and LMT carry a serial number, ST does not. EMT is not supported
/// and gets no answer (§5.4.3).
enum class FrameType : quint8 { St, Mt, Lmt };

inline constexpr int maximumMessageSize = 1472; ///< Bytes of a request or response, header included.
inline constexpr quint16 defaultServerPort = 45237;
inline constexpr quint16 defaultProcessor = 0x03ff;

/// Whom a request is for. The default is the local station (§5.4.2).
struct Route {
    quint8 network = 0; ///< 0, or 1 to 239 for another station.
    quint8 node = 255;  ///< 255 with network 0; else 1 to 120, 125, 126.
    quint16 processor = defaultProcessor;

    bool operator==(const Route&) const = default;
};

inline constexpr Route localStation{};

/// The table "Combination of network numbers and station numbers", §5.4.2 and §5.4.1 notes 6 and 7.
constexpr bool isStation(quint8 network, quint8 node)
{
    if (network == 0)
        return node == 255;
    return network <= 239 && ((node >= 1 && node <= 120) || node == 125 || node == 126);
}

/// The commands of §5.4.3. A message may carry any other number.
enum class Command : quint16 {
    ReadTypeName = 0x0101,
    Read = 0x0401,
    ReadRandom = 0x0403,
    SelfTest = 0x0619,
    NodeSearch = 0x0e30,
    IpAddressSet = 0x0e31,
    DeviceInfoCompare = 0x0e32,
    RemoteRun = 0x1001,
    RemoteStop = 0x1002,
    Write = 0x1401,
    WriteRandom = 0x1402,
};

/// What a request says, apart from how and to whom it travels.
struct Message {
    Command command = Command::Read;
    quint16 subcommand = 0;
    QByteArray data;

    bool operator==(const Message&) const = default;
};

} // namespace lds::slmp

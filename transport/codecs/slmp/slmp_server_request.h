#pragma once

#include "slmp_batch_access.h"
#include "slmp_device_info_compare.h"
#include "slmp_ip_address_set.h"
#include "slmp_node_search.h"
#include "slmp_random_access.h"
#include "slmp_remote_control.h"
#include "slmp_self_test.h"

#include <variant>

/// The sensor's view of a datagram: the commands of §5.4.3's table, in the types it supports them in.
namespace lds::slmp {

using ServerRequest = std::variant<ReadRequest, WriteRequest, ReadRandomRequest, WriteRandomRequest,
                                   RemoteRunRequest, RemoteStopRequest, ReadTypeNameRequest, SelfTestRequest,
                                   NodeSearchRequest, IpAddressSetRequest, DeviceInfoCompareRequest>;

/// Who listens.
struct Station {
    quint8 network = 0;  ///< "Network No.", §5.4.1.
    quint8 node = 255;   ///< "Node No.", §5.4.1.
    HardwareAddress mac; ///< Whom IP Address Set must name.
};

struct AcceptedRequest {
    RequestFrame frame; ///< What the response repeats.
    ServerRequest request;
};

/// Accepted for the local station, in ST and MT also for the own network and node; the processor is 03FFH
/// (§5.4.2 notes).
bool isAddressedTo(const Station& station, FrameType type, const Route& route);

/// The judgment of a message, in this order: silence for Node Search in ST and LMT and for IP Address Set
/// that names another sensor; decodeRequestFrame's; C05CH for another node's; C059H for another command;
/// C05CH for a command that the type does not have (table, note 3); the command's own.
tl::expected<AcceptedRequest, RequestFailure> decodeServerRequest(const QByteArray& datagram,
                                                                  const Station& station);

} // namespace lds::slmp

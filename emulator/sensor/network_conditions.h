#pragma once

#include <QString>
#include <QtGlobal>

namespace lds::emulator {

/// The sensor's "IP setting conditions" (§5.2.1) for an address, a mask and a gateway in host byte order.
/// Empty when they are met; otherwise which one is not.
QString networkObjection(quint32 address, quint32 mask, quint32 gateway);

} // namespace lds::emulator

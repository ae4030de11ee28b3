#pragma once

#include "modbus_pdu.h"
#include "sensor_link.h"

/// What a Modbus answer that carries no result means to the domain.
namespace lds::modbus {

/// Exception codes of §5.2.2 and §6.3.1, which are the same; others are OtherRefusal.
ports::FailureCode refusalOf(quint8 exceptionCode);

/// The stable word of FrameMeaning::Malformed; empty for Refused, which is well formed.
QString wordOf(ResponseError error);

ports::Failure malformed(const QString& what);

} // namespace lds::modbus

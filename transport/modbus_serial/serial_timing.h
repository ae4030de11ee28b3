#pragma once

#include "modbus_pdu.h"
#include "modbus_rtu_framing.h"
#include "serial_settings.h"

/// What follows from the speed of a line: how long an exchange takes and how long to wait for it.
namespace lds::modbus {

/// USB adapters hand on what they have received up to 16 ms later, in pieces.
inline constexpr int adapterDelayMs = 20;

RtuRate rateOf(const ports::SerialSettings& settings);

/// Bytes on the wire, unit and CRC included.
int requestBytes(const Request& request);
int answerBytes(const Request& request); ///< Of the answer that is no exception.

/// The least an exchange takes: request, silence, answer, silence, and the sensor's own time.
qint64 shortestExchangeNs(const ports::SerialSettings& settings, const Request& request,
                          qint64 answeringNs = 0);

/// How long to wait for the answer from the moment the request has been handed to the system, when the
/// sensor may take `answeringMs` before it begins to answer.
int timeoutMs(const ports::SerialSettings& settings, const Request& request, int answeringMs);

/// After so long without a byte whoever was speaking has finished: the silence that ends a frame, and the
/// adapter's delay.
qint64 quietNs(const ports::SerialSettings& settings);

} // namespace lds::modbus

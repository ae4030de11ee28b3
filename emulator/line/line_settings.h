#pragma once

#include "modbus_rtu_framing.h"
#include "serial_codes.h"

namespace lds::emulator {

/// How characters go over an RS-485 line (§6.2). Eight data bits; two stop bits with no parity, one with
/// even or odd, so that a character always takes eleven bits.
struct LineSettings {
    int speed = 38'400; ///< Bits a second, above 0.
    catalog::LineParity parity = catalog::LineParity::Even;

    constexpr modbus::RtuRate rate() const { return {speed, 11}; }
    friend bool operator==(const LineSettings&, const LineSettings&) = default;
};

} // namespace lds::emulator

#pragma once

#include "serial_codes.h"

#include <QMetaType>
#include <QtGlobal>

namespace lds::ports {

using SerialParity = catalog::LineParity; ///< None, Even, Odd: the sensor's own three.

/// How characters go over an RS-485 line of HL-G2 sensors (§6.2). Eight data bits always.
struct SerialSettings {
    int baud = 38'400; ///< Bits a second: 9,600, 19,200, 38,400, 115,200 or 230,400.
    SerialParity parity = SerialParity::Even;

    /// Two with no parity, one with even or odd: the sensor has no other combination.
    constexpr int stopBits() const { return parity == SerialParity::None ? 2 : 1; }
    /// Start, data, parity and stop bits; always 11 here.
    constexpr int bitsPerCharacter() const { return 9 + (parity == SerialParity::None ? 0 : 1) + stopBits(); }
    friend bool operator==(const SerialSettings&, const SerialSettings&) = default;
};

} // namespace lds::ports
Q_DECLARE_METATYPE(lds::ports::SerialSettings)

#pragma once

#include "serial_settings.h"
#include "setting_item.h"

#include <optional>
#include <QMetaType>
#include <QString>
#include <tl/expected.hpp>

namespace lds::ports {

enum class Protocol : quint8 { ModbusTcp, ModbusRtu };

/// Where a sensor is and how to speak to it; the same text in the GUI, the command line and files:
/// modbus-tcp://192.168.1.6:49152?sensor=HL-G203B-S-MK&unit=1&view=only
/// modbus-rtu:/dev/ttyUSB0?baud=38400&parity=even&stop=1&unit=1
struct ConnectionUrl {
    Protocol protocol = Protocol::ModbusTcp;
    QString host;          ///< A name or an address, without brackets; RTU: the serial port as it is opened.
    quint16 port = 502;    ///< 1 … 65535; 502 when the text names none (§5.2.1).
    SerialSettings serial; ///< RTU only (§6.2).
    quint8 unit = 1; ///< RTU: device address, 1 … 247. TCP: without meaning, answered as sent (§5.2.3).
    bool viewOnly = false;                      ///< Never writes.
    std::optional<catalog::SensorModel> sensor; ///< What the person says it is; Modbus does not tell.

    /// Canonical. TCP: defaults are left out, except the port. RTU: speed, parity, stop bits and unit are
    /// always named.
    QString toString() const;
    /// Where it is, for sentences: "192.168.1.6:502"; "/dev/ttyUSB0, unit 3".
    QString place() const;
    /// What tells one sensor from another: without the type and without "view only".
    ConnectionUrl peer() const;
    friend bool operator==(const ConnectionUrl&, const ConnectionUrl&) = default;
};

struct UrlError {
    QString part;     ///< The piece of the text at fault ("port", "scheme", "unit", ...): a stable word.
    QString found;    ///< What stands there.
    QString expected; ///< English, for messages of the command line ("a number from 1 to 65535").
};

/// Unknown schemes, hosts that are none, numbers out of range and unknown parameters are errors.
tl::expected<ConnectionUrl, UrlError> parseConnectionUrl(const QString& text);

} // namespace lds::ports
Q_DECLARE_METATYPE(lds::ports::ConnectionUrl)

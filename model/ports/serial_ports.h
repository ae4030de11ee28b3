#pragma once

#include <QList>
#include <QString>

namespace lds::ports {

/// A serial port of this computer.
struct SerialPortDescription {
    QString name;        ///< As it is opened: "/dev/ttyUSB0", "COM3".
    QString description; ///< "USB-RS485 adapter"; may be empty.
    /// Tells this adapter from others wherever it is plugged in (vendor, product, serial number); empty
    /// when the port has none, as a port on the mainboard.
    QString identity;
    friend bool operator==(const SerialPortDescription&, const SerialPortDescription&) = default;
};

/// The ports there are now. Pseudo-terminals and ports of unusual drivers are not among them: a name may
/// always be typed by hand.
class SerialPorts {
public:
    virtual ~SerialPorts() = default;
    virtual QList<SerialPortDescription> list() const = 0;
};

} // namespace lds::ports

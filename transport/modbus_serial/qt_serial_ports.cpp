#include "qt_serial_ports.h"

#include <QSerialPortInfo>

namespace lds::modbus {

namespace {

QString identityOf(const QSerialPortInfo& port)
{
    if (!port.hasVendorIdentifier() || !port.hasProductIdentifier())
        return {};
    return QStringLiteral("%1:%2:%3")
        .arg(port.vendorIdentifier(), 4, 16, QLatin1Char('0'))
        .arg(port.productIdentifier(), 4, 16, QLatin1Char('0'))
        .arg(port.serialNumber());
}

/// "/dev/ttyUSB0", but "COM3" where the location is "\\.\COM3".
QString nameOf(const QSerialPortInfo& port)
{
    return port.systemLocation().startsWith(QLatin1Char('/')) ? port.systemLocation() : port.portName();
}

} // namespace

QList<ports::SerialPortDescription> QtSerialPorts::list() const
{
    QList<ports::SerialPortDescription> descriptions;
    for (const QSerialPortInfo& port : QSerialPortInfo::availablePorts())
        descriptions.append({nameOf(port), port.description(), identityOf(port)});
    return descriptions;
}

} // namespace lds::modbus

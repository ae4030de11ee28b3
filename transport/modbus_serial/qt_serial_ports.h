#pragma once

#include "serial_ports.h"

namespace lds::modbus {

/// What the system lists.
class QtSerialPorts final : public ports::SerialPorts {
public:
    QList<ports::SerialPortDescription> list() const override;
};

} // namespace lds::modbus

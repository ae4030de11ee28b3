#pragma once

#include "bus_scan.h"
#include "modbus_bus_scan.h"
#include "rtu_bus_pool.h"

#include <memory>
#include <QThread>

namespace lds::modbus {

/// Makes scans that share the serial ports of the links and live in their thread. The pool's thread must
/// outlive the scans, and the scans the factory of the links.
class ModbusScanFactory final : public ports::BusScanFactory {
public:
    ModbusScanFactory(std::shared_ptr<RtuBusPool> pool, QThread& thread, const ScanTiming& timing = {});

    ports::BusScanPointer createScan() override;

private:
    const std::shared_ptr<RtuBusPool> m_pool;
    QThread& m_thread;
    const ScanTiming m_timing;
};

} // namespace lds::modbus

#include "modbus_scan_factory.h"

#include "bus_scan_line.h"

namespace lds::modbus {

ModbusScanFactory::ModbusScanFactory(std::shared_ptr<RtuBusPool> pool, QThread& thread,
                                     const ScanTiming& timing)
    : m_pool(std::move(pool))
    , m_thread(thread)
    , m_timing(timing)
{}

ports::BusScanPointer ModbusScanFactory::createScan()
{
    ports::BusScanPointer scan(new ModbusBusScan(std::make_unique<BusScanLine>(m_pool), m_timing));
    scan->moveToThread(&m_thread);
    return scan;
}

} // namespace lds::modbus

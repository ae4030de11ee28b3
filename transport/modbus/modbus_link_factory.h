#pragma once

#include "frame.h"
#include "rtu_bus_pool.h"
#include "sensor_link.h"
#include "serial_ports.h"

#include <atomic>
#include <memory>
#include <QThread>

namespace lds::modbus {

/// Makes links for modbus-tcp:// and modbus-rtu: URLs, all living in one I/O thread of its own, each with a
/// clock there. The links of one serial port share it.
///
/// The links must be gone (their LinkPointers reset) before the factory is; its destructor then waits for
/// the thread to have deleted them, which takes no longer than the thread's current event. `log` is used
/// from the I/O thread and outlives the factory.
class ModbusLinkFactory final : public ports::LinkFactory {
public:
    explicit ModbusLinkFactory(ports::FrameLog& log);
    /// `ports` tells adapters apart; used in the I/O thread.
    ModbusLinkFactory(ports::FrameLog& log, std::unique_ptr<ports::SerialPorts> ports);
    ~ModbusLinkFactory() override;
    ModbusLinkFactory(const ModbusLinkFactory&) = delete;
    ModbusLinkFactory& operator=(const ModbusLinkFactory&) = delete;

    ports::LinkPointer create(const ports::ConnectionUrl& url) override;

    /// The buses of the links, for others that use the same ports (scans). They and what they do belong into
    /// thread() and end before the factory does.
    const std::shared_ptr<RtuBusPool>& buses() const { return m_buses; }
    QThread& thread() { return m_thread; }

private:
    ports::FrameLog& m_log;
    const std::shared_ptr<RtuBusPool> m_buses;
    QThread m_thread;
    std::atomic<int> m_alive = 0;
};

} // namespace lds::modbus

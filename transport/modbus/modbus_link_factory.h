#pragma once

#include "frame.h"
#include "sensor_link.h"

#include <atomic>
#include <memory>
#include <QThread>

namespace lds::modbus {

/// Makes links for modbus-tcp:// URLs, all living in one I/O thread of its own, each with a clock there.
///
/// The links must be gone (their LinkPointers reset) before the factory is; its destructor then waits for
/// the thread to have deleted them, which takes no longer than the thread's current event. `log` is used
/// from the I/O thread and outlives the factory.
class ModbusLinkFactory final : public ports::LinkFactory {
public:
    explicit ModbusLinkFactory(ports::FrameLog& log);
    ~ModbusLinkFactory() override;
    ModbusLinkFactory(const ModbusLinkFactory&) = delete;
    ModbusLinkFactory& operator=(const ModbusLinkFactory&) = delete;

    ports::LinkPointer create(const ports::ConnectionUrl& url) override;

private:
    ports::FrameLog& m_log;
    QThread m_thread;
    std::atomic<int> m_alive = 0;
};

} // namespace lds::modbus

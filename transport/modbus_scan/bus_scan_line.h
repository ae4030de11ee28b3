#pragma once

#include "rtu_bus_pool.h"
#include "scan_line.h"

#include <memory>

namespace lds::modbus {

/// A scan's place on a serial bus, beside the links that use the port: it takes turns with them.
class BusScanLine final : public ScanLine {
    Q_OBJECT

public:
    explicit BusScanLine(std::shared_ptr<RtuBusPool> pool);
    ~BusScanLine() override; ///< Closes.

    void open(const QString& port, const ports::SerialSettings& serial) override;
    void exchange(const QByteArray& request, int windowMs, int silenceMs) override;
    void close() override;

private:
    void fail(const PortFailure& failure);
    void later(std::function<void()> work); ///< Unless close() comes first.

    const std::shared_ptr<RtuBusPool> m_pool;
    std::shared_ptr<RtuBus> m_bus;
    QString m_port;
    ports::SerialSettings m_serial;
    Ticket m_ticket = 0;
    int m_closings = 0;
};

} // namespace lds::modbus

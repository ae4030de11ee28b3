#pragma once

#include "connection.h"
#include "rtu_bus_pool.h"

namespace lds::modbus {

/// One sensor's place on a serial bus. Opening opens the port when nobody has it open yet; closing leaves it
/// to the others, and the last one closes it.
class BusMember final : public Connection {
    Q_OBJECT

public:
    BusMember(const ports::ConnectionUrl& url, FrameRecorder& recorder, std::shared_ptr<RtuBusPool> pool);
    ~BusMember() override;
    static ConnectionMaker maker(std::shared_ptr<RtuBusPool> pool);

    void open(int timeoutMs) override; ///< Ends within the call.
    void close(const QString& reason) override;
    bool isOpen() const override { return m_bus && m_bus->isOpen(); }
    void send(const Request& request, Turn turn, int timeoutMs, const Ended& ended) override;
    bool isBusy() const override { return m_busy; }
    bool isShared() const override { return true; }
    bool withdraw() override;
    void hurry(Turn turn) override;

private:
    void onLost(ports::OpenFailure failure, const QString& detail);

    const ports::ConnectionUrl m_url;
    FrameRecorder& m_recorder;
    const std::shared_ptr<RtuBusPool> m_pool;
    std::shared_ptr<RtuBus> m_bus; ///< While open.
    Ticket m_ticket = 0;
    bool m_busy = false;
};

} // namespace lds::modbus

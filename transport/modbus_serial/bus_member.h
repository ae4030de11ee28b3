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
    bool isBusy(Turn turn) const override { return place(turn) != 0; }
    bool isShared() const override { return true; }
    void hurry(Turn turn) override;

private:
    /// The ticket of the poll, or of the request, under way; 0 when there is none.
    Ticket& place(Turn turn) { return turn == Turn::Poll ? m_poll : m_request; }
    Ticket place(Turn turn) const { return turn == Turn::Poll ? m_poll : m_request; }
    void onLost(ports::OpenFailure failure, const QString& detail);

    const ports::ConnectionUrl m_url;
    FrameRecorder& m_recorder;
    const std::shared_ptr<RtuBusPool> m_pool;
    std::shared_ptr<RtuBus> m_bus; ///< While open.
    Ticket m_request = 0;
    Ticket m_poll = 0;
};

} // namespace lds::modbus

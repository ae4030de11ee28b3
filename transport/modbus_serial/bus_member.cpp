#include "bus_member.h"

namespace lds::modbus {

BusMember::BusMember(const ports::ConnectionUrl& url, FrameRecorder& recorder,
                     std::shared_ptr<RtuBusPool> pool)
    : m_url(url)
    , m_recorder(recorder)
    , m_pool(std::move(pool))
{}

BusMember::~BusMember() { BusMember::close(QStringLiteral("closed")); }

ConnectionMaker BusMember::maker(std::shared_ptr<RtuBusPool> pool)
{
    return [pool = std::move(pool)](const ports::ConnectionUrl& url, ports::Scheduler&,
                                    FrameRecorder& recorder) -> std::unique_ptr<Connection> {
        return std::make_unique<BusMember>(url, recorder, pool);
    };
}

void BusMember::open(int)
{
    Q_ASSERT(!m_bus);
    m_recorder.connecting();
    auto joined = m_pool->join(m_url.host, m_url.serial);
    if (!joined) {
        m_recorder.disconnected(joined.error().detail);
        Q_EMIT failed(joined.error().failure, joined.error().detail);
        return;
    }
    m_bus = std::move(*joined);
    connect(m_bus.get(), &RtuBus::lost, this, &BusMember::onLost);
    m_recorder.connected();
    Q_EMIT opened();
}

void BusMember::close(const QString& reason)
{
    if (!m_bus)
        return;
    m_bus->disconnect(this);
    for (const Turn turn : {Turn::Person, Turn::Poll})
        m_bus->forget(std::exchange(place(turn), 0));
    m_bus->leave(m_recorder);
    m_bus.reset();
    m_recorder.disconnected(reason);
}

void BusMember::send(const Request& request, Turn turn, int timeoutMs, const Ended& ended)
{
    Q_ASSERT(isOpen() && !isBusy(turn));
    place(turn) = m_bus->ask(
        {m_url.unit, turn, request, timeoutMs, &m_recorder, [this, turn, ended](const Exchange& exchange) {
             place(turn) = 0;
             ended(exchange);
         }});
}

void BusMember::hurry(Turn turn)
{
    if (m_request != 0)
        m_bus->hurry(m_request, turn);
}

void BusMember::onLost(ports::OpenFailure failure, const QString& detail)
{
    m_bus->disconnect(this);
    m_bus->leave(m_recorder);
    m_bus.reset();
    m_request = m_poll = 0;
    m_recorder.disconnected(detail);
    Q_EMIT lost(failure, detail);
}

} // namespace lds::modbus

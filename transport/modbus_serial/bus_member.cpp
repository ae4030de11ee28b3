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
    if (m_busy)
        m_bus->forget(m_ticket);
    m_busy = false;
    m_bus.reset();
    m_recorder.disconnected(reason);
}

void BusMember::send(const Request& request, Turn turn, int timeoutMs, const Ended& ended)
{
    Q_ASSERT(isOpen() && !isBusy());
    m_busy = true;
    m_ticket = m_bus->ask(
        {m_url.unit, turn, request, timeoutMs, &m_recorder, [this, ended](const Exchange& exchange) {
             m_busy = false;
             ended(exchange);
         }});
}

bool BusMember::withdraw()
{
    if (!m_busy || !m_bus->withdraw(m_ticket))
        return false;
    m_busy = false;
    return true;
}

void BusMember::hurry(Turn turn)
{
    if (m_busy)
        m_bus->hurry(m_ticket, turn);
}

void BusMember::onLost(ports::OpenFailure failure, const QString& detail)
{
    m_bus->disconnect(this);
    m_bus.reset();
    m_recorder.disconnected(detail);
    Q_EMIT lost(failure, detail);
}

} // namespace lds::modbus

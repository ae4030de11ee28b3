#include "bus_scan_line.h"

namespace lds::modbus {

BusScanLine::BusScanLine(std::shared_ptr<RtuBusPool> pool)
    : m_pool(std::move(pool))
{}

BusScanLine::~BusScanLine() { BusScanLine::close(); }

void BusScanLine::open(const QString& port, const ports::SerialSettings& serial)
{
    m_serial = serial;
    if (m_bus && m_port == port)
        return later([this] { Q_EMIT opened(); });
    close();
    const auto visited = m_pool->visit(port, serial);
    if (!visited)
        return later([this, failure = visited.error()] { fail(failure); });
    m_bus = *visited;
    m_port = port;
    connect(m_bus.get(), &RtuBus::lost, this, [this](ports::OpenFailure failure, const QString& detail) {
        fail({failure, detail});
    });
    later([this] { Q_EMIT opened(); });
}

void BusScanLine::exchange(const QByteArray& request, int windowMs, int silenceMs)
{
    if (!m_bus)
        return;
    const auto ended = [this, closings = m_closings](const RtuBus::Heard& result) {
        if (closings != m_closings)
            return;
        m_ticket = 0;
        if (result)
            later([this, bytes = *result] { Q_EMIT heard(bytes); });
        else
            later([this, failure = result.error()] { fail(failure); });
    };
    m_ticket = m_bus->listen({request, m_serial, windowMs, silenceMs, ended});
}

void BusScanLine::close()
{
    ++m_closings;
    if (!m_bus)
        return;
    m_bus->disconnect(this);
    if (m_ticket != 0)
        m_bus->forget(std::exchange(m_ticket, 0));
    m_bus.reset();
}

void BusScanLine::fail(const PortFailure& failure)
{
    close();
    Q_EMIT failed(failure.detail);
}

void BusScanLine::later(std::function<void()> work)
{
    QMetaObject::invokeMethod(
        this,
        [this, work = std::move(work), closings = m_closings] {
            if (closings == m_closings)
                work();
        },
        Qt::QueuedConnection);
}

} // namespace lds::modbus

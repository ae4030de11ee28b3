#include "rtu_bus_pool.h"

#include "qmodbus_serial_line.h"
#include "qt_scheduler.h"

#include <QFileInfo>

namespace lds::modbus {

using ports::OpenFailure;
using ports::SerialPortDescription;

namespace {

/// One name for one port: links such as /dev/serial/by-id/… lead to where they point.
QString systemName(const QString& port)
{
    const QString canonical = QFileInfo(port).canonicalFilePath();
    return canonical.isEmpty() ? port : canonical;
}

bool isSamePort(const SerialPortDescription& description, const QString& port)
{
    return description.name == port || systemName(description.name) == systemName(port);
}

} // namespace

RtuBusPool::RtuBusPool(std::unique_ptr<ports::SerialPorts> ports)
    : RtuBusPool(
          std::move(ports), [] { return std::make_unique<ports::QtScheduler>(); },
          [](ports::Scheduler& scheduler) { return std::make_unique<QModbusSerialLine>(scheduler); })
{}

RtuBusPool::RtuBusPool(std::unique_ptr<ports::SerialPorts> ports, Clocks clocks, Lines lines)
    : m_ports(std::move(ports))
    , m_clocks(std::move(clocks))
    , m_lines(std::move(lines))
{}

tl::expected<std::shared_ptr<RtuBus>, PortFailure> RtuBusPool::join(const QString& port,
                                                                    const ports::SerialSettings& settings)
{
    return visit(port, settings)
        .and_then(
            [&](const std::shared_ptr<RtuBus>& bus) -> tl::expected<std::shared_ptr<RtuBus>, PortFailure> {
                if (bus->settings() == settings)
                    return bus;
                return tl::unexpected(
                    PortFailure{OpenFailure::PortSettingsDiffer,
                                QStringLiteral("open with %1 bps").arg(bus->settings().baud)});
            });
}

tl::expected<std::shared_ptr<RtuBus>, PortFailure> RtuBusPool::visit(const QString& port,
                                                                     const ports::SerialSettings& settings)
{
    const auto found = find(port);
    if (!found)
        return tl::unexpected(found.error());
    const QString name = systemName(*found);
    if (auto bus = m_buses.value(name).lock(); bus && bus->isOpen())
        return bus;
    auto scheduler = m_clocks();
    auto line = m_lines(*scheduler);
    // Given up in the middle of what it is doing, as a rule: closed at once, deleted afterwards.
    const std::shared_ptr<RtuBus> bus(new RtuBus(std::move(scheduler), std::move(line)), [](RtuBus* last) {
        last->close();
        last->deleteLater();
    });
    if (const auto opened = bus->open(*found, settings); !opened)
        return tl::unexpected(opened.error());
    m_buses.insert(name, bus);
    remember(port, *found);
    return bus;
}

/// The name under which the port can be opened now.
tl::expected<QString, PortFailure> RtuBusPool::find(const QString& port) const
{
    const QString identity = m_identities.value(port);
    if (identity.isEmpty())
        return port;
    QList<SerialPortDescription> candidates;
    for (const SerialPortDescription& description : m_ports->list()) {
        if (description.identity != identity)
            continue;
        if (isSamePort(description, port))
            return port;
        candidates.append(description);
    }
    if (candidates.size() == 1)
        return candidates.first().name;
    // Adapters without serial numbers look alike; a guess might write to another line's sensors.
    return tl::unexpected(
        PortFailure{OpenFailure::NoSuchPort, candidates.isEmpty()
                                                 ? QStringLiteral("adapter %1 is not there").arg(identity)
                                                 : QStringLiteral("several adapters are %1").arg(identity)});
}

void RtuBusPool::remember(const QString& port, const QString& opened)
{
    for (const SerialPortDescription& description : m_ports->list()) {
        if (isSamePort(description, opened) && !description.identity.isEmpty())
            m_identities.insert(port, description.identity);
    }
}

} // namespace lds::modbus

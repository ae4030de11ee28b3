#pragma once

#include "rtu_bus.h"
#include "serial_ports.h"

#include <functional>
#include <memory>
#include <QHash>

namespace lds::modbus {

/// The buses there are: one for each open serial port, shared by all that use it. Used in the links' thread
/// only, but for making and destroying it.
///
/// A bus lives as long as somebody holds it, and its port is open for as long as it lives. An adapter that
/// was once opened is known by its identity from then on: it is found under whatever name it comes back, and
/// another one that got its name is not taken for it.
class RtuBusPool {
public:
    using Clocks = std::function<std::unique_ptr<ports::Scheduler>()>;
    using Lines = std::function<std::unique_ptr<SerialLine>(ports::Scheduler&)>;

    explicit RtuBusPool(std::unique_ptr<ports::SerialPorts> ports);
    RtuBusPool(std::unique_ptr<ports::SerialPorts> ports, Clocks clocks, Lines lines); ///< For tests.

    /// The bus of a port, opened with these settings when it is not open. Settings other than those it is
    /// open with are PortSettingsDiffer. Keep it to keep the port open.
    tl::expected<std::shared_ptr<RtuBus>, PortFailure> join(const QString& port,
                                                            const ports::SerialSettings& settings);
    /// The bus of a port whatever its settings are, since RtuBus::listen() brings its own; opened with these
    /// when it is not open.
    tl::expected<std::shared_ptr<RtuBus>, PortFailure> visit(const QString& port,
                                                             const ports::SerialSettings& settings);

private:
    tl::expected<QString, PortFailure> find(const QString& port) const;
    void remember(const QString& port, const QString& opened);

    std::unique_ptr<ports::SerialPorts> m_ports;
    Clocks m_clocks;
    Lines m_lines;
    QHash<QString, std::weak_ptr<RtuBus>> m_buses; ///< By the port as the system names it.
    QHash<QString, QString> m_identities;          ///< By the port as a person names it.
};

} // namespace lds::modbus

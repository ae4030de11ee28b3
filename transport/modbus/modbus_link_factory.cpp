#include "modbus_link_factory.h"

#include "bus_member.h"
#include "modbus_link.h"
#include "qt_scheduler.h"
#include "qt_serial_ports.h"
#include "tcp_connection.h"

namespace lds::modbus {

namespace {

/// Over a serial line `answering` is the sensor's own time: what the line takes is added to it.
constexpr ModbusLink::Timing serialTiming{
    .connectMs = 0, .probeMs = 150, .requestMs = 150, .silenceMs = 5000};

} // namespace

ModbusLinkFactory::ModbusLinkFactory(ports::FrameLog& log)
    : ModbusLinkFactory(log, std::make_unique<QtSerialPorts>())
{}

ModbusLinkFactory::ModbusLinkFactory(ports::FrameLog& log, std::unique_ptr<ports::SerialPorts> ports)
    : m_log(log)
    , m_buses(std::make_shared<RtuBusPool>(std::move(ports)))
{
    m_thread.setObjectName(QStringLiteral("links"));
    m_thread.start();
}

ModbusLinkFactory::~ModbusLinkFactory()
{
    // A link that was given up waits for its deletion in the thread's event queue; a thread that ends
    // carries such deletions out. Only a link somebody still holds would be left without a thread.
    m_thread.quit();
    m_thread.wait();
    Q_ASSERT_X(m_alive == 0, "ModbusLinkFactory", "a link outlives its factory");
}

ports::LinkPointer ModbusLinkFactory::create(const ports::ConnectionUrl& url)
{
    auto scheduler = std::make_unique<ports::QtScheduler>();
    ports::LinkPointer link(
        url.protocol == ports::Protocol::ModbusRtu
            ? new ModbusLink(url, std::move(scheduler), m_log, BusMember::maker(m_buses), serialTiming)
            : new ModbusLink(url, std::move(scheduler), m_log, TcpConnection::maker()));
    ++m_alive;
    QObject::connect(
        link.get(), &QObject::destroyed, link.get(), [this] { --m_alive; }, Qt::DirectConnection);
    link->moveToThread(&m_thread);
    return link;
}

} // namespace lds::modbus

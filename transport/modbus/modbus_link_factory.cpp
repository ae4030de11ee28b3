#include "modbus_link_factory.h"

#include "modbus_link.h"
#include "qt_scheduler.h"
#include "tcp_connection.h"

namespace lds::modbus {

ModbusLinkFactory::ModbusLinkFactory(ports::FrameLog& log)
    : m_log(log)
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
    ports::LinkPointer link(
        new ModbusLink(url, std::make_unique<ports::QtScheduler>(), m_log, TcpConnection::maker()));
    ++m_alive;
    QObject::connect(
        link.get(), &QObject::destroyed, link.get(), [this] { --m_alive; }, Qt::DirectConnection);
    link->moveToThread(&m_thread);
    return link;
}

} // namespace lds::modbus

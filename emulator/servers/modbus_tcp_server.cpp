#include "modbus_tcp_server.h"

#include "modbus_connection.h"
#include "modbus_tcp_framing.h"

#include <algorithm>
#include <numeric>
#include <QTcpSocket>

namespace lds::emulator {

ModbusTcpServer::ModbusTcpServer(VirtualSensor& sensor, EmulatorClock& clock, QObject* parent)
    : QObject(parent)
    , m_sensor(sensor)
    , m_clock(clock)
    , m_responder(sensor)
{}

ModbusTcpServer::~ModbusTcpServer() { close(); }

tl::expected<quint16, QString> ModbusTcpServer::listen(const QHostAddress& address, quint16 port)
{
    auto server = std::make_unique<QTcpServer>();
    if (!server->listen(address, port))
        return tl::unexpected(server->errorString());
    m_address = address;
    m_server = std::move(server);
    connect(m_server.get(), &QTcpServer::newConnection, this, &ModbusTcpServer::acceptConnections);
    return m_server->serverPort();
}

tl::expected<void, QString> ModbusTcpServer::moveTo(quint16 port)
{
    if (port == this->port())
        return {};
    const auto listening = listen(address(), port); // the old one goes only when the new one listens
    if (!listening)
        return tl::unexpected(listening.error());
    return {};
}

void ModbusTcpServer::close()
{
    m_server.reset();
    qDeleteAll(std::exchange(m_clients, {}));
}

void ModbusTcpServer::acceptConnections()
{
    while (QTcpSocket* socket = m_server->nextPendingConnection()) {
        if (m_standing.connectionsDropped || m_clients.size() >= mostClients) {
            socket->abort();
            socket->deleteLater();
            continue;
        }
        auto* connection = new ModbusConnection(socket, m_clock, this);
        m_clients.append(connection);
        connect(connection, &ModbusConnection::messageReceived, this,
                [this, connection](const QByteArray& message) { handle(connection, message); });
        connect(connection, &ModbusConnection::bytesReceived, this,
                [this](qint64 count) { m_receivedBytes += count; });
        connect(connection, &ModbusConnection::closed, this, [this, connection] {
            m_clients.removeOne(connection);
            connection->deleteLater();
        });
    }
}

void ModbusTcpServer::closeAllConnections()
{
    const auto clients = m_clients; // closing takes them out of the list
    for (ModbusConnection* connection : clients)
        connection->close();
}

void ModbusTcpServer::closeAllAfterAnswers()
{
    for (ModbusConnection* connection : std::as_const(m_clients))
        connection->closeAfterAnswers();
}

void ModbusTcpServer::abortAllConnections()
{
    const auto clients = m_clients; // aborting takes them out of the list
    for (ModbusConnection* connection : clients)
        connection->abort();
}

void ModbusTcpServer::setStandingFaults(const StandingFaults& faults)
{
    m_standing = faults;
    if (m_standing.connectionsDropped)
        abortAllConnections();
}

void ModbusTcpServer::handle(ModbusConnection* connection, const QByteArray& message)
{
    const modbus::TcpHeader header = modbus::decodeHeader(message);
    const QByteArray pdu = message.mid(modbus::headerSize);
    const auto functionCode = quint8(pdu.at(0)); // there are at least 12 bytes
    ++m_requestCounts[functionCode];
    const auto fault = m_faults.take(functionCode);
    if (m_silent || fault == Fault::IgnoreRequest)
        return;
    if (fault == Fault::CloseBeforeCarryOut) {
        connection->close();
        return;
    }
    if (m_before)
        m_before();
    QByteArray answer = m_responder.answer(pdu);
    Q_EMIT requestHandled(functionCode);
    if (fault == Fault::DropAnswer || m_standing.answersLost)
        return;
    if (fault == Fault::CloseAfterCarryOut) {
        connection->close();
        return;
    }
    const auto transaction =
        quint16(fault == Fault::WrongTransaction ? header.transaction ^ 0x5555 : header.transaction);
    answer = modbus::encodeFrame(transaction, header.unit, answer);
    if (fault == Fault::CutAnswer || m_standing.answersCut)
        answer.chop(2);
    connection->send(answer, std::max({m_answerDelayMs, m_standing.answerDelayMs, m_sensor.silentForMs()}));
}

void ModbusTcpServer::injectFault(Fault fault, FaultOn on, int times) { m_faults.add(fault, on, times); }

void ModbusTcpServer::resetCounts()
{
    m_requestCounts.clear();
    m_receivedBytes = 0;
}

int ModbusTcpServer::totalRequestCount() const
{
    return std::accumulate(m_requestCounts.begin(), m_requestCounts.end(), 0);
}

} // namespace lds::emulator

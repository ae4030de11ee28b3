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
{
    connect(&m_server, &QTcpServer::newConnection, this, &ModbusTcpServer::acceptConnections);
}

ModbusTcpServer::~ModbusTcpServer() { close(); }

tl::expected<quint16, QString> ModbusTcpServer::listen(const QHostAddress& address, quint16 port)
{
    if (!m_server.listen(address, port))
        return tl::unexpected(m_server.errorString());
    return m_server.serverPort();
}

void ModbusTcpServer::close()
{
    m_server.close();
    qDeleteAll(std::exchange(m_clients, {}));
}

void ModbusTcpServer::acceptConnections()
{
    while (QTcpSocket* socket = m_server.nextPendingConnection()) {
        if (m_clients.size() >= mostClients) {
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
    QByteArray answer = m_responder.answer(pdu);
    Q_EMIT requestHandled(functionCode);
    if (fault == Fault::DropAnswer)
        return;
    if (fault == Fault::CloseAfterCarryOut) {
        connection->close();
        return;
    }
    const auto transaction =
        quint16(fault == Fault::WrongTransaction ? header.transaction ^ 0x5555 : header.transaction);
    answer = modbus::encodeFrame(transaction, header.unit, answer);
    if (fault == Fault::CutAnswer)
        answer.chop(2);
    connection->send(answer, std::max(m_answerDelayMs, m_sensor.silentForMs()));
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

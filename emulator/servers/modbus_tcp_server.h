#pragma once

#include "emulator_clock.h"
#include "modbus_responder.h"
#include "server_faults.h"
#include "standing_faults.h"

#include <QHash>
#include <QHostAddress>
#include <QList>
#include <QObject>
#include <QTcpServer>

#include <functional>
#include <memory>

namespace lds::emulator {

class ModbusConnection;

/// One TCP port of a virtual sensor: the Modbus port and the tool port behave alike (§5.2.1). Lives in the
/// sensor's thread.
class ModbusTcpServer : public QObject, public FaultyServer {
    Q_OBJECT

public:
    static constexpr int mostClients = 16; ///< Further ones are closed at once.

    ModbusTcpServer(VirtualSensor& sensor, EmulatorClock& clock, QObject* parent = nullptr);
    ~ModbusTcpServer() override;

    /// Port 0 picks a free one. The error says why it could not listen.
    tl::expected<quint16, QString> listen(const QHostAddress& address, quint16 port);
    void close(); ///< Stops listening and ends all connections.
    bool isListening() const { return m_server != nullptr; }
    quint16 port() const { return m_server ? m_server->serverPort() : quint16(0); } ///< 0: not listening.
    QHostAddress address() const { return m_address; } ///< It listens there, or did last.
    /// Listens at another port of the same address; connections stay. The error says why not, and then
    /// it listens where it did, if it did.
    tl::expected<void, QString> moveTo(quint16 port);
    /// Stops listening; connections stay. For two servers that change places.
    void stopListening() { m_server.reset(); }
    int clientCount() const { return int(m_clients.size()); }

    ModbusResponder& responder() { return m_responder; }

    // Faults on purpose, and counts.
    /// Spoils the answers to the next `times` requests of that kind.
    void injectFault(Fault fault, FaultOn on = FaultOn::AnyRequest, int times = 1);
    void clearFaults() { m_faults.clear(); }
    int faultsWaiting() const { return m_faults.waiting(); }
    void setAnswerDelay(int milliseconds) { m_answerDelayMs = milliseconds; }
    /// Runs before each request is carried out.
    void setBefore(std::function<void()> before) { m_before = std::move(before); }
    void setSilent(bool silent) { m_silent = silent; } ///< Takes requests and does nothing with them.
    void setStandingFaults(const StandingFaults& faults) override;
    void closeAllConnections();
    /// Takes no more requests; each connection ends when its answers under way have gone out.
    void closeAllAfterAnswers();
    void abortAllConnections(); ///< At once, as when the power goes.
    int requestCount(quint8 functionCode) const { return m_requestCounts.value(functionCode); }
    int totalRequestCount() const;
    qint64 receivedBytes() const { return m_receivedBytes; } ///< Of all clients, whole messages or not.
    void resetCounts();

Q_SIGNALS:
    void requestHandled(quint8 functionCode);

private:
    void acceptConnections();
    void handle(ModbusConnection* connection, const QByteArray& message);

    VirtualSensor& m_sensor;
    EmulatorClock& m_clock;
    ModbusResponder m_responder;
    QHostAddress m_address;
    std::unique_ptr<QTcpServer> m_server; ///< Nothing while it does not listen.
    QList<ModbusConnection*> m_clients;
    std::function<void()> m_before;
    ServerFaults m_faults;
    StandingFaults m_standing;
    QHash<quint8, int> m_requestCounts;
    qint64 m_receivedBytes = 0;
    int m_answerDelayMs = 0;
    bool m_silent = false;
};

} // namespace lds::emulator

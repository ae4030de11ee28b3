#pragma once

#include "modbus_tcp_server.h"
#include "virtual_sensor.h"

#include <QMap>
#include <QObject>

namespace lds::emulator {

/// Lets the Ethernet settings of a virtual sensor take effect on its servers: at a communication reset
/// (§4.8.5) and when the power comes back. A changed port is moved to; the address stays what the station
/// was started at, since a virtual sensor never leaves it.
class StationNetwork final : public QObject {
    Q_OBJECT

public:
    StationNetwork(VirtualSensor& sensor, ModbusTcpServer& modbus, ModbusTcpServer& tool);

Q_SIGNALS:
    void portMoved(const QString& message);    ///< For the log: which server listens where now.
    void portNotMoved(const QString& message); ///< Why, and where the server listens still.

private:
    struct Move {
        ModbusTcpServer* server;
        QString role;
        quint16 from;
        quint16 to;
    };

    void resetCommunication();
    void comeBack();
    bool takeOver();
    void movePorts();
    void move(const Move& move);

    VirtualSensor& m_sensor;
    ModbusTcpServer& m_modbus;
    ModbusTcpServer& m_tool;
    QMap<catalog::ItemId, catalog::Value> m_inEffect;
    QMap<catalog::ItemId, catalog::Value> m_before; ///< What was in effect when the ports were last moved.
};

} // namespace lds::emulator

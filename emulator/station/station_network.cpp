#include "station_network.h"

namespace lds::emulator {

using namespace catalog;
using namespace Qt::StringLiterals;

namespace {

/// Chapter 5 is Ethernet, chapter 6 is RS-485, on which no server of a station depends.
bool isEthernet(const SettingItem& item)
{
    return item.effect == Effect::AfterCommunicationReset && item.section[0] == '5';
}

QMap<ItemId, Value> ethernetInEffect(const VirtualSensor& sensor)
{
    QMap<ItemId, Value> values;
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (isEthernet(item))
            values.insert(item.id, sensor.activeValue(item.id));
    }
    return values;
}

QString place(const ModbusTcpServer& server, quint16 port)
{
    return u"%1 port %2"_s.arg(server.address().toString()).arg(port);
}

} // namespace

StationNetwork::StationNetwork(VirtualSensor& sensor, ModbusTcpServer& modbus, ModbusTcpServer& tool)
    : m_sensor(sensor)
    , m_modbus(modbus)
    , m_tool(tool)
    , m_inEffect(ethernetInEffect(sensor))
    , m_before(m_inEffect)
{
    connect(&sensor, &VirtualSensor::communicationReset, this, &StationNetwork::resetCommunication);
    connect(&sensor, &VirtualSensor::poweredOn, this, &StationNetwork::comeBack);
}

/// True when something changed.
bool StationNetwork::takeOver()
{
    const auto now = ethernetInEffect(m_sensor);
    if (now == m_inEffect)
        return false;
    m_inEffect = now;
    return true;
}

void StationNetwork::resetCommunication()
{
    if (!takeOver())
        return;
    m_modbus.closeAllAfterAnswers();
    m_tool.closeAllAfterAnswers();
    // Later: the message that resets is being carried out by one of these servers.
    QMetaObject::invokeMethod(this, &StationNetwork::movePorts, Qt::QueuedConnection);
}

void StationNetwork::comeBack()
{
    m_modbus.abortAllConnections();
    m_tool.abortAllConnections();
    if (takeOver())
        QMetaObject::invokeMethod(this, &StationNetwork::movePorts, Qt::QueuedConnection);
}

void StationNetwork::movePorts()
{
    const auto before = std::exchange(m_before, m_inEffect);
    QList<Move> moves;
    const auto consider = [&](ModbusTcpServer& server, const QString& role, ItemId item) {
        const auto wanted = quint16(m_inEffect.value(item));
        if (server.isListening() && wanted != before.value(item) && wanted != server.port())
            moves.append({&server, role, server.port(), wanted});
    };
    consider(m_modbus, u"Modbus"_s, ItemId::PortModbus);
    consider(m_tool, u"tool"_s, ItemId::PortTool);
    if (moves.size() == 2 && moves.at(0).to == moves.at(1).from)
        moves.swapItemsAt(0, 1); // whoever leaves a place that is wanted goes first
    if (moves.size() == 2 && moves.at(0).to == moves.at(1).from)
        moves.at(1).server->stopListening(); // they change places
    for (const Move& each : std::as_const(moves))
        move(each);
}

void StationNetwork::move(const Move& move)
{
    ModbusTcpServer& server = *move.server;
    const auto moved = server.moveTo(move.to);
    if (moved) {
        Q_EMIT portMoved(u"the %1 server listens on %2 now"_s.arg(move.role, place(server, move.to)));
        return;
    }
    QString message =
        u"the %1 server cannot listen on %2: %3"_s.arg(move.role, place(server, move.to), moved.error());
    if (!server.isListening() && !server.moveTo(move.from))
        message += u"; nor on port %1 any more"_s.arg(move.from);
    else
        message += u"; it stays on port %1"_s.arg(move.from);
    Q_EMIT portNotMoved(message);
}

} // namespace lds::emulator

#pragma once

#include "emulator_clock.h"
#include "modbus_tcp_server.h"
#include "virtual_sensor.h"

#include <memory>
#include <optional>
#include <QHostAddress>
#include <QString>

namespace lds::emulator {

/// What a virtual sensor is to be and where it is to be reached.
struct StationOptions {
    catalog::SensorModel model = catalog::SensorModel::HlG203;
    QHostAddress address = QHostAddress::LocalHost;
    std::optional<quint16> modbusPort; ///< Nothing = no such server; 0 = any free port.
    std::optional<quint16> toolPort;
    QString stateFile; ///< Where the saved memory outlives the program; empty = nowhere.
};

/// Why a station did not start.
struct StationProblem {
    enum class Kind { StateFile, Listen };
    Kind kind;
    QString message; ///< What and where, English, for standard error.
};

/// A virtual sensor and its servers, in one thread.
class SensorStation {
public:
    static tl::expected<std::unique_ptr<SensorStation>, StationProblem> start(const StationOptions& options,
                                                                              EmulatorClock& clock);

    VirtualSensor& sensor() { return m_sensor; }
    ModbusTcpServer& modbusServer() { return m_modbusServer; }
    ModbusTcpServer& toolServer() { return m_toolServer; }
    std::optional<quint16> modbusPort() const { return m_modbusPort; }
    std::optional<quint16> toolPort() const { return m_toolPort; }

private:
    SensorStation(const SettingsMemory& saved, EmulatorClock& clock);

    VirtualSensor m_sensor;
    ModbusTcpServer m_modbusServer;
    ModbusTcpServer m_toolServer;
    std::optional<quint16> m_modbusPort;
    std::optional<quint16> m_toolPort;
};

} // namespace lds::emulator

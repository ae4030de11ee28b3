#pragma once

#include "fault_desk.h"
#include "modbus_tcp_server.h"
#include "replay_clock.h"
#include "rtu_unit.h"
#include "scene_player.h"
#include "station_network.h"
#include "station_state.h"
#include "virtual_sensor.h"

#include <memory>
#include <optional>
#include <QHostAddress>
#include <QObject>
#include <QString>

namespace lds::emulator {

/// What a virtual sensor is to be and where it is to be reached.
struct StationOptions {
    catalog::SensorModel model = catalog::SensorModel::HlG203;
    QHostAddress address = QHostAddress::LocalHost;
    std::optional<quint16> modbusPort; ///< Nothing = no such server; 0 = any free port.
    std::optional<quint16> toolPort;
    QString stateFile; ///< Where the saved memory outlives the program; empty = nowhere.
    QString scene;     ///< A file, or an example's key; empty = a workpiece that moves gently.
    /// The pseudo-terminal of an RS-485 line, which whoever owns the line makes; empty = none.
    QString rtuLink;
    /// Its Device Address at the start, 1 … 247, as if written and not saved; nothing = the saved one.
    std::optional<quint8> unit;
    int answeringTimeMs = 0; ///< On an RS-485 line, from the end of a request to the answer.
};

/// Why a station did not start.
struct StationProblem {
    enum class Kind { StateFile, Scene, Listen };
    Kind kind;
    QString message; ///< What and where, English, for standard error.
};

/// A virtual sensor with what it looks at, what goes wrong with it, and its servers; in one thread.
class SensorStation final : public QObject {
    Q_OBJECT

public:
    using Started = tl::expected<std::unique_ptr<SensorStation>, StationProblem>;

    /// Reads its files and listens nowhere yet.
    static Started prepare(const StationOptions& options, EmulatorClock& clock);
    tl::expected<void, StationProblem> listen();
    static Started start(const StationOptions& options, EmulatorClock& clock); ///< Both.

    VirtualSensor& sensor() { return m_sensor; }
    EmulatorClock& clock() { return m_sensorClock; } ///< The sensor's time.
    ScenePlayer& player() { return m_player; }
    FaultDesk& faults() { return m_faults; }
    ModbusTcpServer& modbusServer() { return m_modbusServer; }
    ModbusTcpServer& toolServer() { return m_toolServer; }
    /// For an RS-485 line, whose owner attaches it (RtuLine::attach).
    RtuUnit& rtuUnit() { return m_rtuUnit; }
    std::optional<quint16> modbusPort() const { return portOf(m_modbusServer); } ///< Nothing: no such server.
    std::optional<quint16> toolPort() const { return portOf(m_toolServer); }

    /// A file, or an example's key; empty = the workpiece that moves gently. The error names file and field,
    /// and then everything stays as it is.
    tl::expected<void, QString> loadScene(const QString& pathOrExample);
    StationState state() const;

Q_SIGNALS:
    void stateChanged();
    void networkChanged(const QString& message); ///< A server moved to another port, or could not.

private:
    SensorStation(const StationOptions& options, const SettingsMemory& saved, EmulatorClock& clock);
    void takeUnit(quint8 unit);
    static std::optional<quint16> portOf(const ModbusTcpServer& server);

    const StationOptions m_options;
    ReplayClock m_sensorClock;
    VirtualSensor m_sensor;
    ModbusTcpServer m_modbusServer;
    ModbusTcpServer m_toolServer;
    RtuUnit m_rtuUnit;
    FaultDesk m_faults;
    ScenePlayer m_player;
    StationNetwork m_network;
    QString m_scene; ///< As it was loaded.
};

} // namespace lds::emulator

#include "sensor_station.h"

#include "state_file.h"

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

tl::unexpected<StationProblem> problem(StationProblem::Kind kind, const QString& message)
{
    return tl::unexpected(StationProblem{kind, message});
}

tl::expected<void, StationProblem> listenAt(ModbusTcpServer& server, const QString& role,
                                            const QHostAddress& address, std::optional<quint16> port)
{
    if (!port)
        return {};
    if (const auto listening = server.listen(address, *port); !listening) {
        return problem(StationProblem::Kind::Listen,
                       u"cannot listen on %1 port %2 (%3): %4"_s.arg(address.toString())
                           .arg(*port)
                           .arg(role, listening.error()));
    }
    return {};
}

} // namespace

SensorStation::SensorStation(const StationOptions& options, const SettingsMemory& saved, EmulatorClock& clock)
    : m_options(options)
    , m_sensorClock(clock)
    , m_sensor(saved, m_sensorClock)
    , m_modbusServer(m_sensor, clock)
    , m_toolServer(m_sensor, clock)
    , m_rtuUnit(m_sensor)
    , m_faults(m_sensor, {&m_modbusServer, &m_toolServer, &m_rtuUnit}, clock)
    , m_player(m_sensor, m_faults, clock, m_sensorClock)
    , m_network(m_sensor, m_modbusServer, m_toolServer)
{
    const auto follow = [this] { m_player.follow(); };
    m_sensorClock.setBefore(follow);
    m_modbusServer.setBefore(follow);
    m_toolServer.setBefore(follow);
    m_rtuUnit.setBefore(follow);
    m_rtuUnit.setAnsweringTime(options.answeringTimeMs);
    connect(&m_faults, &FaultDesk::changed, this, &SensorStation::stateChanged);
    connect(&m_player, &ScenePlayer::changed, this, &SensorStation::stateChanged);
    connect(&m_network, &StationNetwork::portMoved, this, &SensorStation::networkChanged);
    connect(&m_network, &StationNetwork::portNotMoved, this, &SensorStation::networkChanged);
}

SensorStation::Started SensorStation::prepare(const StationOptions& options, EmulatorClock& clock)
{
    SavedState saved{SettingsMemory(options.model), {}};
    if (!options.stateFile.isEmpty()) {
        const auto loaded = StateFile(options.stateFile).load(options.model);
        if (!loaded)
            return problem(StationProblem::Kind::StateFile, loaded.error());
        saved = loaded->value_or(saved);
    }
    std::unique_ptr<SensorStation> station(new SensorStation(options, saved.settings, clock));
    station->m_sensor.setLife(saved.life);
    if (!options.stateFile.isEmpty()) {
        station->m_sensor.setStore(
            [file = StateFile(options.stateFile)](const SettingsMemory& memory, const LifeCounters& life) {
                return file.save(memory, life);
            });
    }
    if (options.unit)
        station->takeUnit(*options.unit);
    if (const auto loaded = station->loadScene(options.scene); !loaded)
        return problem(StationProblem::Kind::Scene, loaded.error());
    return station;
}

/// As a person would do it over the line: the address, and then a communication reset.
void SensorStation::takeUnit(quint8 unit)
{
    m_sensor.write({{catalog::ItemId::DeviceAddress, unit}});
    m_sensor.write({{catalog::ItemId::ResettingCommunicationSettings, 0}});
}

tl::expected<void, StationProblem> SensorStation::listen()
{
    const QHostAddress& address = m_options.address;
    if (auto listening = listenAt(m_modbusServer, u"Modbus"_s, address, m_options.modbusPort); !listening)
        return listening;
    return listenAt(m_toolServer, u"tool"_s, address, m_options.toolPort);
}

SensorStation::Started SensorStation::start(const StationOptions& options, EmulatorClock& clock)
{
    Started station = prepare(options, clock);
    if (!station)
        return station;
    if (const auto listening = (*station)->listen(); !listening)
        return tl::unexpected(listening.error());
    return station;
}

std::optional<quint16> SensorStation::portOf(const ModbusTcpServer& server)
{
    return server.isListening() ? std::optional(server.port()) : std::nullopt;
}

tl::expected<void, QString> SensorStation::loadScene(const QString& pathOrExample)
{
    std::shared_ptr<const Scene> scene;
    if (!pathOrExample.isEmpty()) {
        const auto loaded = Scene::load(pathOrExample, m_sensor.model());
        if (!loaded)
            return tl::unexpected(loaded.error());
        scene = *loaded;
    }
    m_scene = pathOrExample;
    m_player.play(scene);
    return {};
}

StationState SensorStation::state() const
{
    StationState state;
    state.scene = m_scene;
    if (const auto& scene = m_player.scene()) {
        state.sceneName = scene->name();
        state.workpieces = scene->workpieces();
    }
    state.held = m_player.held();
    state.heldAt = m_player.heldAt();
    for (const NamedFault fault : allFaults()) {
        state.faults.append({fault, m_faults.isOn(fault, FaultDesk::By::Person),
                             m_faults.isOn(fault, FaultDesk::By::Scene), m_faults.milliseconds(fault)});
    }
    state.triggerByPerson = m_player.triggerByPerson();
    state.triggerByScene = m_player.triggerByScene();
    return state;
}

} // namespace lds::emulator

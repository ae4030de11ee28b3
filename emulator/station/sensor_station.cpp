#include "sensor_station.h"

#include "state_file.h"

namespace lds::emulator {

using namespace Qt::StringLiterals;

namespace {

tl::expected<std::optional<quint16>, StationProblem>
listen(ModbusTcpServer& server, const QString& role, const QHostAddress& address, std::optional<quint16> port)
{
    if (!port)
        return std::nullopt;
    const auto listening = server.listen(address, *port);
    if (!listening) {
        return tl::unexpected(StationProblem{StationProblem::Kind::Listen,
                                             u"cannot listen on %1 port %2 (%3): %4"_s.arg(address.toString())
                                                 .arg(*port)
                                                 .arg(role, listening.error())});
    }
    return *listening;
}

} // namespace

SensorStation::SensorStation(const SettingsMemory& saved, EmulatorClock& clock)
    : m_sensor(saved, clock)
    , m_modbusServer(m_sensor, clock)
    , m_toolServer(m_sensor, clock)
{}

tl::expected<std::unique_ptr<SensorStation>, StationProblem>
SensorStation::start(const StationOptions& options, EmulatorClock& clock)
{
    SettingsMemory saved(options.model);
    if (!options.stateFile.isEmpty()) {
        const auto loaded = StateFile(options.stateFile).load(options.model);
        if (!loaded)
            return tl::unexpected(StationProblem{StationProblem::Kind::StateFile, loaded.error()});
        saved = loaded->value_or(saved);
    }
    std::unique_ptr<SensorStation> station(new SensorStation(saved, clock));
    if (!options.stateFile.isEmpty()) {
        station->m_sensor.setStore([file = StateFile(options.stateFile)](const SettingsMemory& memory) {
            return file.save(memory);
        });
    }
    const auto modbusPort = listen(station->m_modbusServer, u"Modbus"_s, options.address, options.modbusPort);
    if (!modbusPort)
        return tl::unexpected(modbusPort.error());
    const auto toolPort = listen(station->m_toolServer, u"tool"_s, options.address, options.toolPort);
    if (!toolPort)
        return tl::unexpected(toolPort.error());
    station->m_modbusPort = *modbusPort;
    station->m_toolPort = *toolPort;
    return station;
}

} // namespace lds::emulator

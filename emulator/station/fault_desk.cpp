#include "fault_desk.h"

#include <algorithm>

namespace lds::emulator {

namespace {

/// Nothing for a fault of the servers.
std::optional<SensorFault> sensorFault(NamedFault fault)
{
    switch (fault) {
    case NamedFault::NoLight:
        return SensorFault::NoLight;
    case NamedFault::Saturated:
        return SensorFault::Saturated;
    case NamedFault::AmbientLight:
        return SensorFault::AmbientLight;
    case NamedFault::OutOfRange:
        return SensorFault::OutOfRange;
    case NamedFault::LaserCircuitError:
        return SensorFault::LaserCircuitError;
    case NamedFault::SystemError:
        return SensorFault::SystemError;
    case NamedFault::InMenu:
        return SensorFault::InMenu;
    case NamedFault::SlowAnswers:
    case NamedFault::AnswersLost:
    case NamedFault::AnswersCut:
    case NamedFault::ConnectionDropped:
    case NamedFault::Saving:
        break;
    }
    return std::nullopt;
}

} // namespace

FaultDesk::FaultDesk(VirtualSensor& sensor, const QList<FaultyServer*>& servers, EmulatorClock& clock)
    : m_sensor(sensor)
    , m_servers(servers)
    , m_clock(clock)
{
    connect(&sensor, &VirtualSensor::poweredOn, this, [this] {
        endSaving(By::Person);
        endSaving(By::Scene);
    });
}

bool FaultDesk::isOn(NamedFault fault, By by) const { return of(by).contains(fault); }

int FaultDesk::milliseconds(NamedFault fault) const
{
    int longest = 0;
    for (const Switches& switches : m_on) {
        if (const auto on = switches.find(fault); on != switches.end())
            longest = std::max(longest, on->second.milliseconds);
    }
    return longest;
}

void FaultDesk::switchOn(NamedFault fault, By by, std::optional<int> milliseconds)
{
    Switch& on = of(by)[fault];
    if (const auto usual = defaultMilliseconds(fault))
        on.milliseconds = std::clamp(milliseconds.value_or(*usual), 0, longestMs);
    if (fault == NamedFault::Saving)
        startSaving(by, on);
    else
        apply(fault);
    Q_EMIT changed();
}

void FaultDesk::startSaving(By by, Switch& on)
{
    m_sensor.beSilentForMs(on.milliseconds);
    m_clock.cancel(on.end);
    on.end = m_clock.after(m_sensor.silentForMs(), this, [this, by] { endSaving(by); });
}

void FaultDesk::endSaving(By by)
{
    const auto on = of(by).find(NamedFault::Saving);
    if (on == of(by).end())
        return;
    m_clock.cancel(on->second.end);
    of(by).erase(on);
    Q_EMIT changed();
}

void FaultDesk::switchOff(NamedFault fault, By by)
{
    if (fault == NamedFault::Saving || of(by).erase(fault) == 0)
        return;
    apply(fault);
    Q_EMIT changed();
}

void FaultDesk::switchAllOff(By by)
{
    const Switches on = of(by);
    for (const auto& [fault, how] : on)
        switchOff(fault, by);
}

void FaultDesk::apply(NamedFault fault)
{
    if (const auto ofSensor = sensorFault(fault)) {
        m_sensor.setFault(*ofSensor, isOn(fault));
        return;
    }
    const StandingFaults faults{milliseconds(NamedFault::SlowAnswers), isOn(NamedFault::AnswersLost),
                                isOn(NamedFault::AnswersCut), isOn(NamedFault::ConnectionDropped)};
    for (FaultyServer* server : m_servers)
        server->setStandingFaults(faults);
}

} // namespace lds::emulator

#pragma once

#include "emulator_clock.h"
#include "named_fault.h"
#include "standing_faults.h"
#include "virtual_sensor.h"

#include <array>
#include <map>
#include <optional>
#include <QList>
#include <QObject>

namespace lds::emulator {

/// Makes named faults happen to a virtual sensor and its servers. A person and the scene switch them
/// independently of each other; a fault is on while either has it on. A power cycle changes nothing here.
class FaultDesk final : public QObject {
    Q_OBJECT

public:
    enum class By : quint8 { Person, Scene };
    static constexpr int longestMs = 3'600'000; ///< Of slowAnswers and saving; longer becomes this.

    FaultDesk(VirtualSensor& sensor, const QList<FaultyServer*>& servers, EmulatorClock& clock);

    /// `milliseconds` is for the faults that take one, their default when nothing is given.
    void switchOn(NamedFault fault, By by, std::optional<int> milliseconds = {});
    /// Saving goes off by itself: after its time, or when the power is cycled.
    void switchOff(NamedFault fault, By by);
    void switchAllOff(By by);
    bool isOn(NamedFault fault) const { return isOn(fault, By::Person) || isOn(fault, By::Scene); }
    bool isOn(NamedFault fault, By by) const;
    /// The longest that is on; 0 when the fault is off or takes no time.
    int milliseconds(NamedFault fault) const;

Q_SIGNALS:
    void changed();

private:
    struct Switch {
        int milliseconds = 0;
        EmulatorClock::TimerId end = 0; ///< Of saving.
    };
    using Switches = std::map<NamedFault, Switch>; ///< Those that are on.

    Switches& of(By by) { return m_on[std::size_t(by)]; }
    const Switches& of(By by) const { return m_on[std::size_t(by)]; }
    void startSaving(By by, Switch& on);
    void endSaving(By by);
    void apply(NamedFault fault);

    VirtualSensor& m_sensor;
    const QList<FaultyServer*> m_servers;
    EmulatorClock& m_clock;
    std::array<Switches, 2> m_on;
};

} // namespace lds::emulator

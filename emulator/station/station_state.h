#pragma once

#include "named_fault.h"
#include "setting_item.h"

#include <optional>
#include <QList>
#include <QMetaType>
#include <QString>
#include <QStringList>

namespace lds::emulator {

/// What a person can change at a station, as it is now: a value, for screens and control lines.
struct StationState {
    struct Fault {
        NamedFault fault = NamedFault::NoLight;
        bool byPerson = false;
        bool byScene = false;
        int milliseconds = 0; ///< While it is on; 0 when it takes no time.
        bool operator==(const Fault&) const = default;
    };

    QString scene;     ///< As it was loaded: the key of an example or a path; empty: moves gently.
    QString sceneName; ///< As the scene names itself.
    QStringList workpieces;
    QString held;                         ///< The workpiece held still; empty when none is.
    std::optional<catalog::Value> heldAt; ///< A place held instead, 0.1 µm from the centre.
    QList<Fault> faults;                  ///< All there are, in the order of allFaults().
    bool triggerByPerson = false;
    bool triggerByScene = false;
    bool operator==(const StationState&) const = default;
};

} // namespace lds::emulator

Q_DECLARE_METATYPE(lds::emulator::StationState)

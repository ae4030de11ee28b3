#pragma once

#include "named_fault.h"
#include "setting_item.h"

#include <optional>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>
#include <variant>

namespace lds::app {

/// What one control line asks (docs/emulator.md).
struct ControlCommand {
    struct Status {};
    struct Help {};
    struct PowerCycle {};
    struct Scene {
        QString pathOrExample; ///< Empty: the workpiece that moves gently.
    };
    struct HoldWorkpiece {
        QString name;
    };
    struct HoldAt {
        catalog::Value rawValue; ///< 0.1 µm
    };
    struct LetMove {};
    struct Fault {
        emulator::NamedFault fault;
        bool on;
        std::optional<int> milliseconds;
    };
    struct Trigger {
        bool on;
    };
    using What =
        std::variant<Status, Help, PowerCycle, Scene, HoldWorkpiece, HoldAt, LetMove, Fault, Trigger>;

    std::optional<int> sensor; ///< As it was written, from 1; nothing: no sensor was named.
    What what;
};

/// The error says what is wrong and what would be understood. `line` may be anything.
tl::expected<ControlCommand, QString> parseControlLine(const QString& line);
/// One line for each form of a command.
QStringList controlForms();

} // namespace lds::app

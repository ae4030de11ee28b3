#pragma once

#include <optional>
#include <QList>
#include <QString>

namespace lds::emulator {

/// What can go wrong on purpose, by name: in a scene at its time, or switched by hand.
enum class NamedFault : quint8 {
    NoLight,           ///< Nothing comes back (§4.7: insufficient intensity).
    Saturated,         ///< Excessive intensity of received light (§4.7).
    AmbientLight,      ///< Excessive extraneous light (§4.7).
    OutOfRange,        ///< The workpiece outside the measurement range (§4.13).
    LaserCircuitError, ///< E200 (§8.2).
    SystemError,       ///< E120 (§8.2).
    SlowAnswers,       ///< Answers come late, by `milliseconds`.
    AnswersLost,       ///< Requests are carried out and never answered.
    AnswersCut,        ///< Answers lose their last bytes.
    ConnectionDropped, ///< Connections end, and nobody gets a new one.
    InMenu,            ///< Somebody is in the setting mode: not ready (§5.2.2).
    Saving,            ///< Silent, as while writing to its memory, for `milliseconds` (§5.3.3).
};

/// "noLight", "saturated", … as scenes, control lines and programs write them.
QString keyOf(NamedFault fault);
/// Nothing for a name that is none.
std::optional<NamedFault> faultNamed(const QString& key);
const QList<NamedFault>& allFaults();
/// Whether the fault takes a number of milliseconds (slowAnswers, saving), and which one when none is given.
std::optional<int> defaultMilliseconds(NamedFault fault);

} // namespace lds::emulator

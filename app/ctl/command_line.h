#pragma once

#include "connection_url.h"

#include <optional>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>
#include <variant>

namespace lds::ctl {

enum class Verb { Catalog, Info, Read, Set, Monitor };

/// What a command line asks for, proven as far as that is possible without a sensor.
struct CommandLine {
    Verb verb = Verb::Catalog;
    bool json = false;
    std::optional<ports::ConnectionUrl> url; ///< Present with every verb but Catalog.
    QStringList arguments;                   ///< Keys or KEY=VALUE, as typed.
    bool save = false;                       ///< Set only.
    std::optional<int> durationMs;           ///< Monitor only; without it until interrupted.
    int intervalMs = 10;                     ///< Monitor only.
    QString csvFile;                         ///< Monitor only; empty without one.
};

/// --help and --version: nothing to do but to say this.
struct Answer {
    QString text;
};

struct UsageError {
    QString message;
};

/// Reads the program's arguments, the program's name first.
tl::expected<std::variant<CommandLine, Answer>, UsageError> parseCommandLine(const QStringList& arguments);

} // namespace lds::ctl

#pragma once

#include "exit_code.h"

namespace lds::ctl {

class Console;
struct CommandLine;

/// ldsctl catalog: what the tool knows about the sensor family, without a sensor.
class CatalogCommand {
public:
    CatalogCommand(const CommandLine& line, Console& console);
    ExitCode run() const;

private:
    const CommandLine& m_line;
    Console& m_console;
};

} // namespace lds::ctl

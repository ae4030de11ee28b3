#pragma once

#include "precise_clock.h"
#include "pseudo_terminal.h"
#include "rtu_line.h"

#include <memory>
#include <QString>
#include <tl/expected.hpp>

namespace lds::emulator {

/// A line and the pseudo-terminal at which programs reach it.
class RtuPort {
public:
    /// `link`: see PseudoTerminal::open().
    static tl::expected<std::unique_ptr<RtuPort>, QString> open(const QString& link, EmulatorClock& clock);

    RtuLine& line() { return m_line; }
    QString link() const { return m_terminal->link(); } ///< Absolute.

private:
    RtuPort(std::unique_ptr<PseudoTerminal> terminal, EmulatorClock& clock);

    std::unique_ptr<PseudoTerminal> m_terminal;
    PreciseClock m_clock;
    RtuLine m_line;
};

} // namespace lds::emulator

#include "rtu_port.h"

namespace lds::emulator {

RtuPort::RtuPort(std::unique_ptr<PseudoTerminal> terminal, EmulatorClock& clock)
    : m_terminal(std::move(terminal))
    , m_clock(clock)
    , m_line(*m_terminal, m_clock)
{}

tl::expected<std::unique_ptr<RtuPort>, QString> RtuPort::open(const QString& link, EmulatorClock& clock)
{
    auto terminal = PseudoTerminal::open(link, clock);
    if (!terminal)
        return tl::unexpected(terminal.error());
    return std::unique_ptr<RtuPort>(new RtuPort(std::move(*terminal), clock));
}

} // namespace lds::emulator

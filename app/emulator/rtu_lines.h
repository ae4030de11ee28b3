#pragma once

#include "rtu_port.h"

#include <map>
#include <memory>
#include <QString>
#include <tl/expected.hpp>

namespace lds::app {

/// The RS-485 lines of the program: sensors that name the same link share one.
class RtuLines {
public:
    explicit RtuLines(emulator::EmulatorClock& clock)
        : m_clock(clock)
    {}

    /// The link's absolute path. The error names the link.
    tl::expected<QString, QString> attach(emulator::RtuUnit& unit, const QString& link);

private:
    emulator::EmulatorClock& m_clock;
    std::map<QString, std::unique_ptr<emulator::RtuPort>> m_ports; ///< By absolute path.
};

} // namespace lds::app

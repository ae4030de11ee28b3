#pragma once

namespace lds::ctl {

/// What scripts rely on.
enum class ExitCode {
    Done = 0,
    Refused = 1, ///< The sensor or the link said no, or there is no connection.
    Usage = 2,   ///< The command line asks for something that cannot be.
};

} // namespace lds::ctl

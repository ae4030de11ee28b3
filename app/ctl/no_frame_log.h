#pragma once

#include "frame.h"

namespace lds::ctl {

/// Nobody looks at the frames of a command line.
class NoFrameLog final : public ports::FrameLog {
public:
    void record(const ports::Frame&) override {}
};

} // namespace lds::ctl

#pragma once

#include <QtGlobal>

namespace lds::emulator {

/// Something that is on for a while, once or again and again. Milliseconds since the scene began.
struct Interval {
    qint64 atMs = 0;
    qint64 forMs = 0;   ///< 0: from then on.
    qint64 everyMs = 0; ///< 0: once; otherwise longer than forMs.
    /// Whether it is on at this moment.
    bool covers(qint64 timeMs) const;
};

} // namespace lds::emulator

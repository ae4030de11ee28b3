#include "interval.h"

namespace lds::emulator {

bool Interval::covers(qint64 timeMs) const
{
    if (timeMs < atMs)
        return false;
    const qint64 since = timeMs - atMs;
    if (forMs <= 0)
        return true;
    return (everyMs > 0 ? since % everyMs : since) < forMs;
}

} // namespace lds::emulator

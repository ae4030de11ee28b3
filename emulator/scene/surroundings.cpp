#include "surroundings.h"

#include "noise.h"

#include <algorithm>
#include <cmath>

namespace lds::emulator {

namespace {

constexpr qint64 nanosecondsPerMillisecond = 1'000'000;

double lightAt(const Surroundings& surroundings, qint64 timeNs)
{
    const qint64 timeMs = timeNs / nanosecondsPerMillisecond;
    double strongest = -1;
    for (const Surroundings::Glare& glare : surroundings.glares) {
        if (glare.level > strongest && glare.when.covers(timeMs))
            strongest = glare.level;
    }
    return strongest < 0 ? surroundings.ambientLight : strongest;
}

} // namespace

Sight Surroundings::showing(const Meeting& meeting, qint64 timeNs) const
{
    const double light = glares.empty() ? ambientLight : lightAt(*this, timeNs);
    if (!meeting.present)
        return {false, 0, 0, light};
    const double height = noise > 0 ? meeting.height + noise * noiseShare(seed, timeNs) : meeting.height;
    return {true, std::llround(height), meeting.reflectance, light};
}

} // namespace lds::emulator

#include "surroundings.h"

#include <algorithm>
#include <cmath>

namespace lds::emulator {

namespace {

constexpr qint64 noiseStepNs = 100'000; ///< The shortest sampling cycle.
constexpr qint64 nanosecondsPerMillisecond = 1'000'000;

/// SplitMix64: a well mixed number for every (seed, step), with no state to keep.
quint64 mixed(quint64 number)
{
    number += 0x9e3779b97f4a7c15ULL;
    number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9ULL;
    number = (number ^ (number >> 27)) * 0x94d049bb133111ebULL;
    return number ^ (number >> 31);
}

/// −1 … 1
double randomShare(quint64 seed, qint64 timeNs)
{
    const quint64 random = mixed(seed ^ mixed(quint64(timeNs / noiseStepNs)));
    return double(random >> 11) * 0x1p-52 - 1.0;
}

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
    const double height = noise > 0 ? meeting.height + noise * randomShare(seed, timeNs) : meeting.height;
    return {true, std::llround(height), meeting.reflectance, light};
}

} // namespace lds::emulator

#include "workpiece.h"

#include "noise.h"
#include "sine.h"

#include <cmath>

namespace lds::emulator {

namespace {

constexpr double shareOfRange = 0.6;    ///< Of the measurement range, so that it is never left.
constexpr double shareOfNoise = 0.0002; ///< Of the measurement range.
constexpr double shareOfGloss = 0.13;   ///< By which the reflectance changes as it moves.
constexpr qint64 slowPeriodMs = 9000;
constexpr qint64 quickPeriodMs = 1700;
constexpr double quickShare = 0.15; ///< Of the amplitude; the slow movement has the rest.

/// Where a movement of this period is: 0 to below 1 turn.
double turnsOf(qint64 timeNs, qint64 periodMs)
{
    const qint64 periodNs = periodMs * 1'000'000;
    return double(timeNs % periodNs) / double(periodNs);
}

} // namespace

Workpiece::Workpiece(const catalog::ModelDescription& model, quint64 seed)
    : m_amplitude(shareOfRange * double(model.measurementRange * nanometresPerWireUnit))
    , m_noise(shareOfNoise * double(model.measurementRange * nanometresPerWireUnit))
    , m_seed(seed)
{}

Sight Workpiece::at(qint64 timeNs) const
{
    const double slow = sineOfTurns(turnsOf(timeNs, slowPeriodMs));
    const double quick = sineOfTurns(turnsOf(timeNs, quickPeriodMs));
    const double noise = m_noise * noiseShare(m_seed, timeNs);
    const double distance = m_amplitude * ((1 - quickShare) * slow + quickShare * quick) + noise;
    return {true, std::llround(distance), 1 + shareOfGloss * slow, 0};
}

} // namespace lds::emulator

#include "workpiece.h"

#include <cmath>
#include <numbers>

namespace lds::emulator {

namespace {

constexpr double shareOfRange = 0.6;    ///< Of the measurement range, so that it is never left.
constexpr double shareOfNoise = 0.0002; ///< Of the measurement range.
constexpr double shareOfGloss = 0.13;   ///< By which the reflectance changes as it moves.
constexpr double slowPeriodSeconds = 9.0;
constexpr double quickPeriodSeconds = 1.7;
constexpr double quickShare = 0.15;     ///< Of the amplitude; the slow movement has the rest.
constexpr qint64 noiseStepNs = 100'000; ///< The shortest sampling cycle.

/// SplitMix64: a well mixed number for every (seed, step), with no state to keep.
quint64 mixed(quint64 number)
{
    number += 0x9e3779b97f4a7c15ULL;
    number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9ULL;
    number = (number ^ (number >> 27)) * 0x94d049bb133111ebULL;
    return number ^ (number >> 31);
}

} // namespace

Workpiece::Workpiece(const catalog::ModelDescription& model, quint64 seed)
    : m_amplitude(shareOfRange * double(model.measurementRange * nanometresPerWireUnit))
    , m_noise(shareOfNoise * double(model.measurementRange * nanometresPerWireUnit))
    , m_seed(seed)
{}

Sight Workpiece::at(qint64 timeNs) const
{
    const double angle = 2 * std::numbers::pi * double(timeNs) * 1e-9;
    const double slow = std::sin(angle / slowPeriodSeconds);
    const double quick = std::sin(angle / quickPeriodSeconds);
    const quint64 random = mixed(m_seed ^ mixed(quint64(timeNs / noiseStepNs)));
    const double noise = m_noise * (double(random >> 11) * 0x1p-52 - 1.0);
    const double distance = m_amplitude * ((1 - quickShare) * slow + quickShare * quick) + noise;
    return {true, std::llround(distance), 1 + shareOfGloss * slow, 0};
}

} // namespace lds::emulator

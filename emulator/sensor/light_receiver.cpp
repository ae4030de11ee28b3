#include "light_receiver.h"

#include <algorithm>
#include <cmath>

namespace lds::emulator {

namespace {

/// Intensity of white ceramic at full brightness and a sampling cycle of 1 ms.
constexpr double intensityOfWhite = 6000;
constexpr double leastIntensity = 40; ///< Below it the waveform cannot be measured.
constexpr double leastBrightness = 0.002;
constexpr double adjustmentStep = 1.25; ///< Of automatic adjustment, for each sample.
// No adjustment while the intensity stays between these.
constexpr double lowestOptimal = 450;
constexpr double highestOptimal = 750;
/// How far a workpiece may differ from the two that were tuned with.
constexpr double rangeMargin = 1.5;
constexpr double cycleUnitNs = 1e6;

} // namespace

Reflection LightReceiver::receive(const Sight& sight, qint64 cycleNs)
{
    m_isOptimal = false;
    if (!sight.present || sight.reflectance <= 0) // nothing to adjust to
        return {sight.distance, 0, Light::Insufficient};
    if (sight.ambientLight >= 1)
        return {sight.distance, mostIntensity, Light::ExtraneousLight};
    const double perBrightness = sight.reflectance * intensityOfWhite * double(cycleNs) / cycleUnitNs;
    const double wanted = wantedIntensity / perBrightness;
    if (m_range)
        adjust(wanted);
    const double before = m_brightness;
    const double intensity = perBrightness * before;
    const bool isAsWanted = intensity >= lowestOptimal && intensity <= highestOptimal;
    if (!m_range && !isAsWanted)
        adjust(wanted);
    if (intensity > mostIntensity)
        return {sight.distance, mostIntensity, Light::Excessive};
    if (intensity < leastIntensity)
        return {sight.distance, quint16(intensity), Light::Insufficient};
    m_isOptimal = m_brightness == before; // as wanted, or as near to it as brightness goes
    return {sight.distance, quint16(intensity), Light::Measurable};
}

void LightReceiver::adjust(double wantedBrightness)
{
    const double allowed = std::clamp(wantedBrightness, leastBrightness, 1.0);
    if (m_range) {
        const double lowest = std::max(leastBrightness, m_range->lowest / rangeMargin / fullBrightness);
        const double highest = std::max(lowest, m_range->highest * rangeMargin / fullBrightness);
        m_brightness = std::clamp(allowed, lowest, std::min(1.0, highest));
        return;
    }
    m_brightness = std::clamp(allowed, m_brightness / adjustmentStep, m_brightness * adjustmentStep);
}

void LightReceiver::settle(const Sight& sight, qint64 cycleNs)
{
    constexpr int enoughSteps = 64; // from one end of the brightness to the other takes fewer
    for (int i = 0; i < enoughSteps; ++i)
        receive(sight, cycleNs);
}

} // namespace lds::emulator

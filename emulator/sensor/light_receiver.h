#pragma once

#include "reflection.h"
#include "scenery.h"

#include <optional>

namespace lds::emulator {

/// The range of laser brightness found by brightness tuning (§4.3.3), in millionths of full brightness.
struct BrightnessRange {
    int lowest = 0;  ///< For the brighter workpiece.
    int highest = 0; ///< For the darker one.
    bool operator==(const BrightnessRange&) const = default;
};

/// Turns what stands under the beam into what the light-receiving element tells (§4.7), and keeps the
/// laser's brightness such that the waveform can be measured: light received grows with reflectance,
/// brightness and sampling cycle (§4.3.1 note). The manual gives no figures; these are chosen so that
/// white ceramic suits every cycle, black rubber needs a long one, and bright metal little brightness.
class LightReceiver {
public:
    static constexpr int fullBrightness = 1'000'000;
    static constexpr int mostIntensity = 1023;
    static constexpr double wantedIntensity = 600;

    /// Automatic adjustment without a range: step by step; within a tuned range: at once.
    void setRange(std::optional<BrightnessRange> range) { m_range = range; }
    Reflection receive(const Sight& sight, qint64 cycleNs);
    /// As if it had looked at this since long.
    void settle(const Sight& sight, qint64 cycleNs);

    int brightness() const { return int(m_brightness * fullBrightness); }
    /// Whether the last intensity could be measured and needs no adjustment: what brightness tuning waits
    /// for.
    bool isOptimal() const { return m_isOptimal; }

private:
    void adjust(double wantedBrightness);

    std::optional<BrightnessRange> m_range;
    double m_brightness = 0.1;
    bool m_isOptimal = false;
};

} // namespace lds::emulator

#pragma once

#include "catalog.h"
#include "lengths.h"

namespace lds::emulator {

enum class Light : quint8 { Measurable, Excessive, Insufficient, ExtraneousLight }; ///< §4.7

/// What the light that comes back tells at one moment.
struct Reflection {
    Nanometres distance = 0;   ///< From the measurement centre; towards the sensor is positive (§4.3.5).
    quint16 peakIntensity = 0; ///< 0 … 1023
    Light light = Light::Measurable;
};

/// A workpiece that moves gently inside the measurement range, with a little noise. A function of time
/// and seed only, so that the same moment always shows the same value.
class Workpiece {
public:
    explicit Workpiece(const catalog::ModelDescription& model, quint64 seed = 1);
    Reflection at(qint64 timeNs) const;

private:
    double m_amplitude; ///< nm
    double m_noise;     ///< nm, half width
    quint64 m_seed;
};

} // namespace lds::emulator

#pragma once

#include "lengths.h"

namespace lds::emulator {

enum class Light : quint8 { Measurable, Excessive, Insufficient, ExtraneousLight }; ///< §4.7

/// What the light that comes back tells at one moment.
struct Reflection {
    Nanometres distance = 0;   ///< From the measurement centre; towards the sensor is positive (§4.3.5).
    quint16 peakIntensity = 0; ///< 0 … 1023
    Light light = Light::Measurable;
};

} // namespace lds::emulator

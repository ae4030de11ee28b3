#pragma once

#include "lengths.h"

#include <QtGlobal>

namespace lds::emulator {

/// What stands under the beam at one moment, before any light of the sensor has fallen on it.
struct Sight {
    bool present = true;      ///< False: nothing sends light back at all.
    Nanometres distance = 0;  ///< From the measurement centre; towards the sensor is positive (§4.3.5).
    double reflectance = 1.0; ///< Share of the light sent back, white ceramic being 1; > 1 for glossy metal.
    double ambientLight = 0;  ///< Extraneous light; 1 and more is what the sensor cannot measure through.
};

/// The surroundings a virtual sensor looks at: a function of time, asked for every sample (down to each
/// 100 µs), so it has to be quick (well under half a microsecond) and must always answer the same for the
/// same moment.
class Scenery {
public:
    virtual ~Scenery() = default;
    /// `timeNs`: nanoseconds since the scenery was put before the sensor; never negative.
    virtual Sight at(qint64 timeNs) const = 0;
};

} // namespace lds::emulator

#pragma once

#include "interval.h"
#include "scenery.h"
#include "track.h"

#include <vector>

namespace lds::emulator {

/// What disturbs every measurement of a scene: noise of the distance, and light that is not the sensor's.
struct Surroundings {
    struct Glare {
        double level;
        Interval when;
    };

    double noise = 0; ///< nm, half width; even between −noise and +noise.
    quint64 seed = 1; ///< Another seed, another noise; the same seed, the same noise at the same moment.
    double ambientLight = 0;
    std::vector<Glare> glares; ///< The strongest one that is on takes the place of ambientLight.

    Sight showing(const Meeting& meeting, qint64 timeNs) const;
};

} // namespace lds::emulator

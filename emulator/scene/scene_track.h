#pragma once

#include "scene_description.h"
#include "track.h"

namespace lds::emulator {

/// Everything that a scene's motion brings under the beam.
Track trackOf(const SceneDescription& scene);

/// A workpiece standing still with its measuring point under the beam.
Meeting meetingAtMeasuringPoint(const SceneDescription& scene, std::size_t workpiece);

} // namespace lds::emulator

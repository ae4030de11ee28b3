#pragma once

#include "scene_description.h"

#include <QByteArray>
#include <tl/expected.hpp>

namespace lds::emulator {

/// Bounds of a scene file: what is beyond them is refused before it costs memory or time.
inline constexpr qint64 largestSceneFile = 1024 * 1024; ///< bytes
inline constexpr qsizetype mostWorkpieces = 100;
inline constexpr qsizetype mostPoints = 1000;       ///< of one profile
inline constexpr qsizetype mostPlaces = 1000;       ///< of an order or a timeline
inline constexpr qsizetype mostStretches = 100'000; ///< points of all places of a conveyor together
inline constexpr qsizetype mostIntervals = 100;     ///< of faults, and of triggers
inline constexpr qsizetype mostGlares = 16;         ///< of ambient light: looked at for every sample
inline constexpr double shortestWorkpiece = 0.001;  ///< mm
inline constexpr double longestWorkpiece = 10'000;  ///< mm; of a gap and a pitch too
inline constexpr double longestTimeMs = 365.0 * 24 * 3600 * 1000;
inline constexpr qsizetype longestWorkpieceName = 64; ///< characters
inline constexpr double mostMillimetres = 1'000;      ///< of a height
inline constexpr double mostRanges = 10;              ///< of a height in shares of the measurement range
inline constexpr double mostLight = 100;              ///< of reflectance and ambient light
inline constexpr double mostMilliseconds = 60'000;    ///< of slowAnswers and saving

/// Reads and checks docs/scenes.md's format. `measurementRange`: nm, what 1 is in "unit": "range".
/// The error names the line and column of what is no JSON, otherwise the field.
tl::expected<SceneDescription, QString> readScene(const QByteArray& json, double measurementRange);

} // namespace lds::emulator

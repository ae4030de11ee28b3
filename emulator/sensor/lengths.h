#pragma once

#include <QtGlobal>

namespace lds::emulator {

/// Lengths inside the virtual sensor are in nanometres: finer than the 0.01 µm in which the sensor
/// compares (§4.4.1), and wide enough for span times display range.
using Nanometres = qint64;
inline constexpr Nanometres nanometresPerWireUnit = 100; ///< One wire unit is 0.1 µm.

} // namespace lds::emulator

#pragma once

#include "catalog.h"
#include "values.h"

namespace lds::settings {

/// The types whose limits and choices admit everything read: HIGH, LOW, hysteresis, offset, tolerance and
/// display digit (protocols.md: Modbus alone does not name the type). Zero when nothing fits: not an HL-G2.
catalog::ModelMask modelsThatFit(const Values& values);

} // namespace lds::settings

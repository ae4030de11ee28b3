#pragma once

#include "setting_item.h"

#include <optional>

/// The codes of the items "Communication speed" and "Parity/Stop Bit" (§6.2) and what they stand for, read
/// from the catalog's choices.
namespace lds::catalog {

enum class LineParity : quint8 { None, Even, Odd };

/// Bits a second; nothing when the code is none of the catalog's.
std::optional<int> lineSpeed(Value code);
std::optional<Value> lineSpeedCode(int bitsPerSecond);

std::optional<LineParity> lineParity(Value code);
Value lineParityCode(LineParity parity);

} // namespace lds::catalog

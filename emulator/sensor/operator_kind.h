#pragma once

#include <QtGlobal>

namespace lds::emulator {

/// Who operates the sensor. What is set at the keys is saved at once; what comes by communication is not
/// (§5.1). While a procedure runs by communication the keys cannot change screens (§4.3.3, §4.9).
enum class Operator : quint8 { Communication, Keys };

} // namespace lds::emulator

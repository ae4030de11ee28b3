#pragma once

#include <QMetaType>

namespace lds::emulator {

/// The three keys of the sensor, by their place. With the display inverted UP and DOWN change their
/// meaning (§4.8.3); the panel knows, whoever presses them need not.
enum class Key : quint8 { Up, Enter, Down };
inline constexpr int keyCount = 3;

} // namespace lds::emulator

Q_DECLARE_METATYPE(lds::emulator::Key)

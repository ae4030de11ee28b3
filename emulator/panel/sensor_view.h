#pragma once

#include "display_content.h"
#include "virtual_sensor.h"

namespace lds::emulator {

// What the display shows of the sensor's measurement (§2.2), apart from where it shows it.

/// The measured value in mm, or +OVER, -OVER, ----, ALARM. `decimals`: 0 … 4.
QString measuredValueText(const VirtualSensor& sensor, int decimals);
/// Decimals of a length at the setting resolution of the type.
int fullDecimals(const VirtualSensor& sensor);
/// As the display digit setting has it (§4.8.1).
int displayDecimals(const VirtualSensor& sensor);
/// 0 … 1023, or ---- (§4.1).
QString receivedLightText(const VirtualSensor& sensor);
/// "E10000"; empty without an error (§8.2).
QString errorText(const VirtualSensor& sensor);
DisplayIcons iconsOf(const VirtualSensor& sensor);
IndicatorState laserIndicator(const VirtualSensor& sensor);
IndicatorState alarmIndicator(const VirtualSensor& sensor);

} // namespace lds::emulator

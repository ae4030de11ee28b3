#pragma once

#include "serial_settings.h"
#include "setting_item.h"

#include <optional>
#include <QList>

/// The speeds and parities of §6.2 as the catalog lists them, and back: nothing is listed twice.
namespace lds::ports {

/// In ascending order: 9,600 … 230,400.
QList<int> serialSpeeds();
/// The code of the item "Communication speed"; nothing when the sensor does not have the speed.
std::optional<catalog::Value> speedCode(int baud);
/// Of the item "Parity/Stop Bit".
catalog::Value parityCode(SerialParity parity);

/// Nothing when a code is none of the catalog's.
std::optional<SerialSettings> serialSettingsOf(catalog::Value speedCode, catalog::Value parityCode);

/// All fifteen, the likeliest first: as delivered, then the other speeds from the fastest with the parity
/// as delivered, then all speeds without parity, then with odd parity.
QList<SerialSettings> everySerialSettings();
/// As delivered and the other speeds with the same parity: the first five of everySerialSettings().
QList<SerialSettings> usualSerialSettings();

} // namespace lds::ports

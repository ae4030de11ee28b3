#pragma once

#include "setting_item.h"

namespace lds::settings {

/// The code is one of the item's choices on this model (the display digit's differ by type, §4.8.1).
bool hasChoice(const catalog::SettingItem& item, catalog::SensorModel model, catalog::Value code);

/// Within the limits of the model, or one of its choices. The resolution is not looked at: what teaching
/// or a message has stored may be finer than it.
bool isLegal(const catalog::SettingItem& item, catalog::SensorModel model, catalog::Value value);

} // namespace lds::settings

#pragma once

#include "sensor_session.h"
#include "setting_row.h"

#include <QStringList>

namespace lds::ui {

/// The rules a row has to keep, in words and with the numbers of the moment: edits where there are some,
/// else what the sensor holds. What the sensor would refuse is decided in model/settings; this explains.
QStringList ruleTexts(const SettingRow& row, const sensor::SensorSession& session);

} // namespace lds::ui

#pragma once

#include "sensor_session.h"
#include "setting_row.h"

#include <QStringList>

/// What the details pane says about a row, as lines. Rich text where a function says so.
namespace lds::ui::detail_texts {

QString path(const SettingRow& row); ///< "Menu 32 · Judgment"
QString help(const SettingRow& row);
/// "−5.0000 → +0.7500 mm", rich text; then resolution, bank or common, and when it takes effect.
QStringList change(const SettingRow& row, const sensor::SensorSession& session);
QStringList rangeAndDefault(const SettingRow& row, const sensor::SensorSession& session);
QStringList addresses(const SettingRow& row);
QString manual(const SettingRow& row); ///< "Manual §4.4.2"
QString conflict(const SettingRow& row, const sensor::SensorSession& session);

} // namespace lds::ui::detail_texts

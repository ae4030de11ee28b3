#pragma once

#include "catalog.h"
#include "value_text.h"

#include <QString>

/// The catalog's texts and values in the person's language. The only place that translates catalog text.
namespace lds::ui {

QString itemName(const catalog::SettingItem& item);
QString itemHelp(const catalog::SettingItem& item);
QString menuName(const catalog::MenuEntry& entry);
QString coilName(const catalog::Coil& coil);
QString choiceName(const catalog::Choice& choice);

/// A value for a person: a choice's name, a typographic number without unit, error code "E100**".
/// An unknown choice code reads "7 (unknown)".
QString displayValue(const catalog::SettingItem& item, catalog::SensorModel model, catalog::Value value);
/// The same with its unit: "+1.7500 mm".
QString displayValueWithUnit(const catalog::SettingItem& item, catalog::SensorModel model,
                             catalog::Value value);
/// "−9.5000 … +9.5000", "1 … 100"; for a choice its names, shortened with "…" when long.
QString rangeText(const catalog::SettingItem& item, catalog::SensorModel model);
QString defaultText(const catalog::SettingItem& item, catalog::SensorModel model);
/// Addresses in words: "Modbus 400103, 2 registers", "EtherNet/IP 2319", "SLMP D102"; empty when none.
QStringList addressTexts(const catalog::SettingItem& item);
/// Four octets (1st first) as "192.168.1.6".
QString octetsText(const QList<catalog::Value>& octets);

} // namespace lds::ui

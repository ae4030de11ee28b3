#pragma once

#include "keys.h"
#include "values.h"

#include <QJsonValue>

namespace lds::ctl {

/// A value as ldsctl prints it, without its unit: exact decimals with an ASCII minus, a choice's English
/// name, "alarm", "indeterminate", "over" or "under" for a measured value that is none (§5.2.4), four
/// numbers for an address. Empty when a part of it is not known.
QString valueWords(const Target& target, catalog::SensorModel model, const settings::Values& values);
/// The unit of what valueWords gives; empty for a word.
QString unitOf(const Target& target, const settings::Values& values);
/// {"value": wire integer, "text": …, "unit": …}; value is a list for an address. null when not known.
QJsonValue valueJson(const Target& target, catalog::SensorModel model, const settings::Values& values);

/// "over", "under", "indeterminate", "alarm"; empty for a length.
QString sentinelWord(catalog::Value measuredValue);

} // namespace lds::ctl

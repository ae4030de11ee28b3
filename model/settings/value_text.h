#pragma once

#include "catalog.h"
#include "values.h"

#include <QString>
#include <tl/expected.hpp>

namespace lds::settings {

/// Exact decimal text of a value in the item's unit: lengths in mm ("+1.2345" with the model's decimals;
/// a value finer than the resolution is shown in full, four decimals), factors with four decimals, ports
/// and counts plain. A true minus sign (U+2212) is used when `typographic`, '-' otherwise (files, CLI).
/// Choices give their code: their text is translated in ui/ and app/ only.
enum class TextStyle { Plain, Typographic };
QString valueText(const catalog::SettingItem& item, catalog::SensorModel model, Value value,
                  TextStyle style = TextStyle::Plain);

/// A measured value (0.1 µm) in mm with `decimals` digits, further digits rounded down towards zero, as
/// the sensor's display does (§4.8.1). Always signed. Sentinels are the caller's business.
QString lengthText(Value tenthsOfMicrometre, int decimals, TextStyle style = TextStyle::Plain);

/// "mm", "ms", "×", "" – no translation: these are SI symbols and a sign.
QString unitText(const catalog::SettingItem& item);

enum class ParseError {
    Empty,
    NotANumber,      ///< Also two decimal separators, letters, a lone sign.
    TooManyDecimals, ///< More digits than a wire unit can hold (0.1 µm, 1/10000).
    OutOfRange,      ///< Outside the item's limits for this model; `value` of ParseFailure is unset.
    NotAChoice,      ///< No such code for this model.
};
struct ParseFailure {
    ParseError error;
    catalog::Limits limits; ///< What would be accepted.
};

struct ParsedValue {
    Value written;   ///< What goes on the wire.
    Value effective; ///< What the sensor makes of it: digits below the resolution rounded down (§1.4).
};

/// Reads a person's text in the item's unit, exactly, without floating point: accepts '-', '−' and '+',
/// '.' or ',' as the decimal separator, surrounding space and the unit ("1.75 mm"); full-width digits,
/// signs and points as a Japanese or Chinese keyboard produces them. For a choice, its code.
tl::expected<ParsedValue, ParseFailure> parseValue(const catalog::SettingItem& item,
                                                   catalog::SensorModel model, const QString& text);

/// The value the sensor keeps when `written` is sent: rounded down towards zero to the resolution.
Value effectiveValue(const catalog::SettingItem& item, catalog::SensorModel model, Value written);

} // namespace lds::settings

#include "value_text.h"

#include "legal_values.h"

#include <QLatin1Char>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>

namespace lds::settings {

namespace {

using catalog::Kind;
using catalog::SettingItem;

constexpr int wireDecimals = 4; ///< Lengths in 0.1 µm shown in mm, factors in 1/10000.
constexpr QChar minusSign(0x2212);

int decimalsOfWireUnit(const SettingItem& item)
{
    return item.kind == Kind::Length || item.kind == Kind::Factor ? wireDecimals : 0;
}

Value resolutionOf(const SettingItem& item, catalog::SensorModel model)
{
    return std::max<Value>(1, item.limitsFor(model).resolution);
}

/// Decimals of the item's unit down to its resolution: 0.1 µm gives 4, 1 µm 3, 10 µm 2.
int decimalsAtResolution(const SettingItem& item, catalog::SensorModel model)
{
    int decimals = decimalsOfWireUnit(item);
    for (Value step = resolutionOf(item, model); step >= 10 && decimals > 0; step /= 10)
        --decimals;
    return decimals;
}

QString sign(bool negative, bool plusWanted, TextStyle style)
{
    if (negative)
        return style == TextStyle::Typographic ? QString(minusSign) : QStringLiteral("-");
    return plusWanted ? QStringLiteral("+") : QString();
}

/// Digits of |value| / 10^4 with `decimals` of them after the point, the rest cut off.
QString fixedPoint(qint64 magnitude, int decimals)
{
    const QString digits = QString::number(magnitude).rightJustified(wireDecimals + 1, u'0');
    const QString whole = digits.chopped(wireDecimals);
    return decimals == 0 ? whole : whole + u'.' + digits.last(wireDecimals).first(decimals);
}

QString decimalText(const SettingItem& item, catalog::SensorModel model, Value value, TextStyle style)
{
    const bool onResolution = value % resolutionOf(item, model) == 0;
    const int decimals = onResolution ? decimalsAtResolution(item, model) : wireDecimals;
    const bool isSigned = item.limitsFor(model).minimum < 0;
    return sign(value < 0, isSigned && value > 0, style) + fixedPoint(std::abs(qint64(value)), decimals);
}

/// §8.2: E and the digits the register holds; the manual's last two are internal and never sent.
QString errorCodeText(Value value)
{
    constexpr int shownDigits = 3;
    if (value == 0)
        return QStringLiteral("0");
    return u'E' + QString::number(quint32(value), 16).toUpper().rightJustified(shownDigits, u'0');
}

// --- Reading what a person typed ---

/// What Japanese and Chinese keyboards produce for the characters of a number. Deliberately not Unicode
/// compatibility decomposition, which would also turn "10²" into 102.
QChar asciiOf(QChar character)
{
    const char16_t code = character.unicode();
    if (code >= u'\uff10' && code <= u'\uff19') // full-width digits
        return QChar(char16_t(u'0' + (code - u'\uff10')));
    if (code >= u'\uff41' && code <= u'\uff5a') // full-width letters, for units
        return QChar(char16_t(u'a' + (code - u'\uff41')));
    switch (code) {
    case u'\uff0b':
        return u'+';
    case u'\u2212': // minus sign
    case u'\uff0d': // full-width hyphen-minus
    case u'\u2010': // hyphens
    case u'\u2011':
    case u'\u30fc': // what the minus key gives in kana input
        return u'-';
    case u',': // decimal separator of half the world
    case u'\uff0e':
    case u'\uff0c':
    case u'\u3001':
    case u'\u3002':
    case u'\uff61':
        return u'.';
    case u'\u3000': // ideographic space
    case u'\u00a0':
    case u'\u202f':
        return u' ';
    default:
        return character;
    }
}

QString toAscii(const QString& text)
{
    QString ascii;
    ascii.reserve(text.size());
    for (const QChar character : text) {
        if (character == u'\u339c') // ㎜
            ascii += QLatin1StringView("mm");
        else if (character == u'\u33b3') // ㎳
            ascii += QLatin1StringView("ms");
        else
            ascii += asciiOf(character);
    }
    return ascii.trimmed();
}

QStringView withoutUnit(QStringView text, const QString& unit)
{
    if (!unit.isEmpty() && text.endsWith(unit))
        text.chop(unit.size());
    return text.trimmed();
}

/// A decimal number taken apart; no arithmetic has happened yet.
struct Decimal {
    bool negative = false;
    QStringView whole;
    QStringView fraction; ///< Without trailing zeros.
};

bool isAllDigits(QStringView text)
{
    return std::all_of(text.begin(), text.end(), [](QChar c) { return c >= u'0' && c <= u'9'; });
}

std::optional<Decimal> splitDecimal(QStringView text)
{
    Decimal decimal;
    decimal.negative = text.startsWith(u'-');
    if (decimal.negative || text.startsWith(u'+'))
        text = text.sliced(1);
    const qsizetype point = text.indexOf(u'.');
    decimal.whole = point < 0 ? text : text.first(point);
    decimal.fraction = point < 0 ? QStringView() : text.sliced(point + 1);
    if (decimal.whole.isEmpty() && decimal.fraction.isEmpty())
        return std::nullopt;
    if (!isAllDigits(decimal.whole) || !isAllDigits(decimal.fraction))
        return std::nullopt;
    while (decimal.fraction.endsWith(u'0'))
        decimal.fraction.chop(1);
    return decimal;
}

/// The number in wire units; nothing when it is larger than any item's limits. The fraction has at most
/// `decimals` digits.
std::optional<Value> toWireUnits(const Decimal& decimal, int decimals)
{
    const QString digits =
        decimal.whole.toString() + decimal.fraction.toString().leftJustified(decimals, u'0');
    qint64 magnitude = 0;
    for (const QChar digit : digits) {
        magnitude = magnitude * 10 + (digit.unicode() - u'0');
        if (magnitude > std::numeric_limits<Value>::max())
            return std::nullopt;
    }
    return Value(decimal.negative ? -magnitude : magnitude);
}

tl::expected<Value, ParseError> parseWireValue(const SettingItem& item, const QString& text)
{
    const QString ascii = toAscii(text);
    const QStringView number = withoutUnit(ascii, unitText(item));
    if (number.isEmpty())
        return tl::unexpected(ascii.isEmpty() ? ParseError::Empty : ParseError::NotANumber);
    const std::optional<Decimal> decimal = splitDecimal(number);
    if (!decimal)
        return tl::unexpected(ParseError::NotANumber);
    const int decimals = decimalsOfWireUnit(item);
    if (decimal->fraction.size() > decimals)
        return tl::unexpected(ParseError::TooManyDecimals);
    const std::optional<Value> value = toWireUnits(*decimal, decimals);
    if (!value)
        return tl::unexpected(item.kind == Kind::Choice ? ParseError::NotAChoice : ParseError::OutOfRange);
    return *value;
}

} // namespace

QString valueText(const SettingItem& item, catalog::SensorModel model, Value value, TextStyle style)
{
    switch (item.kind) {
    case Kind::Length:
    case Kind::Factor:
        return decimalText(item, model, value, style);
    case Kind::ErrorCode:
        return errorCodeText(value);
    case Kind::Choice:
    case Kind::Count:
    case Kind::Duration:
    case Kind::Port:
    case Kind::Octet:
    case Kind::Bits:
    case Kind::Trigger:
    case Kind::MacAddress:
        break;
    }
    return sign(value < 0, false, style) + QString::number(std::abs(qint64(value)));
}

QString lengthText(Value tenthsOfMicrometre, int decimals, TextStyle style)
{
    const int shown = std::clamp(decimals, 0, wireDecimals);
    const QString digits = fixedPoint(std::abs(qint64(tenthsOfMicrometre)), shown);
    const bool isZero =
        std::all_of(digits.begin(), digits.end(), [](QChar c) { return c == u'0' || c == u'.'; });
    return sign(tenthsOfMicrometre < 0 && !isZero, true, style) + digits;
}

QString unitText(const SettingItem& item)
{
    switch (item.kind) {
    case Kind::Length:
        return QStringLiteral("mm");
    case Kind::Duration:
        return QStringLiteral("ms");
    case Kind::Factor:
        return QStringLiteral("×");
    case Kind::Choice:
    case Kind::Count:
    case Kind::Port:
    case Kind::Octet:
    case Kind::Bits:
    case Kind::ErrorCode:
    case Kind::Trigger:
    case Kind::MacAddress:
        break;
    }
    return {};
}

tl::expected<ParsedValue, ParseFailure> parseValue(const SettingItem& item, catalog::SensorModel model,
                                                   const QString& text)
{
    const auto fail = [&](ParseError error) {
        return tl::unexpected(ParseFailure{error, item.limitsFor(model)});
    };
    const tl::expected<Value, ParseError> written = parseWireValue(item, text);
    if (!written)
        return fail(written.error());
    const Value effective = effectiveValue(item, model, *written);
    // Both: 0.0005 mm becomes 0, which a tolerance on the 50 mm type cannot be.
    if (!isLegal(item, model, *written) || !isLegal(item, model, effective))
        return fail(item.kind == Kind::Choice ? ParseError::NotAChoice : ParseError::OutOfRange);
    return ParsedValue{*written, effective};
}

Value effectiveValue(const SettingItem& item, catalog::SensorModel model, Value written)
{
    if (item.kind == Kind::Choice)
        return written;
    return written - written % resolutionOf(item, model); // C++ division is towards zero, as §1.4 is
}

} // namespace lds::settings

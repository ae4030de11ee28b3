#include "item_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace lds::ui {

using catalog::Kind;
using catalog::SettingItem;
using catalog::Value;

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::ItemText)
};

constexpr int longestRangeText = 44; ///< Characters; a column of a table, not a paragraph.
constexpr QChar ellipsis(0x2026);

QString fromCatalog(const char* text)
{
    return text && *text ? QCoreApplication::translate("SettingItem", text) : QString();
}

/// The names of the bits that are set (§5.2.5); reserved bits are left out.
QString bitsText(const SettingItem& item, Value value)
{
    if (!item.modbus)
        return QString::number(value);
    const int first = (item.modbus->number - 400011) * 16 + 1;
    QStringList names;
    for (const auto& coil : catalog::Catalog::hlG2().coils()) {
        const int bit = coil.number - first;
        if (bit >= 0 && bit < 16 && (value >> bit & 1) != 0 && !coil.reserved())
            names += coilName(coil);
    }
    return names.isEmpty() ? Texts::tr("None") : names.join(QStringLiteral(", "));
}

/// Numbers the protocols share for a value that is none (§5.2.4 notes); empty for a value.
QString sentinelText(const SettingItem& item, Value value)
{
    if (item.id == catalog::ItemId::PeakIntensity && value == catalog::sentinel::noIntensity)
        return QStringLiteral("----");
    if (item.id != catalog::ItemId::MeasuredValue)
        return {};
    switch (value) {
    case catalog::sentinel::over:
        return QStringLiteral("+OVER");
    case catalog::sentinel::under:
        return QStringLiteral("\u2212OVER");
    case catalog::sentinel::indeterminate:
        return QStringLiteral("----");
    case catalog::sentinel::alarm:
        return QStringLiteral("ALARM");
    default:
        return {};
    }
}

QString choiceText(const SettingItem& item, Value value)
{
    for (const auto& choice : item.choices) {
        if (choice.code == value)
            return choiceName(choice);
    }
    return Texts::tr("%1 (unknown)").arg(value);
}

QStringList choiceNames(const SettingItem& item, catalog::SensorModel model)
{
    QStringList names;
    for (const auto& choice : item.choices) {
        if (choice.models & catalog::maskOf(model))
            names += choiceName(choice);
    }
    return names;
}

QString choicesRange(const QStringList& names)
{
    const bool isScale = names.size() > 3 && std::all_of(names.begin(), names.end(), [](const QString& name) {
                             return name.at(0).isDigit();
                         });
    if (isScale)
        return names.first() + u' ' + ellipsis + u' ' + names.last();
    QString text;
    for (const QString& name : names) {
        const QString longer = text.isEmpty() ? name : text + QStringLiteral(", ") + name;
        if (longer.size() > longestRangeText)
            return text + QStringLiteral(", ") + ellipsis;
        text = longer;
    }
    return text;
}

} // namespace

QString itemName(const SettingItem& item) { return fromCatalog(item.name); }
QString itemHelp(const SettingItem& item) { return fromCatalog(item.help); }
QString menuName(const catalog::MenuEntry& entry) { return fromCatalog(entry.name); }
QString coilName(const catalog::Coil& coil) { return fromCatalog(coil.name); }
QString choiceName(const catalog::Choice& choice) { return fromCatalog(choice.name); }

QString displayValue(const SettingItem& item, catalog::SensorModel model, Value value)
{
    if (const QString text = sentinelText(item, value); !text.isEmpty())
        return text;
    switch (item.kind) {
    case Kind::Choice:
        return choiceText(item, value);
    case Kind::Bits:
        return bitsText(item, value);
    case Kind::ErrorCode:
        // §8.2: the last two digits are internal and never come over the wire.
        return value == 0 ? Texts::tr("None")
                          : QStringLiteral("E%1**").arg(quint32(value), 3, 16, QLatin1Char('0')).toUpper();
    case Kind::Trigger:
    case Kind::MacAddress:
        return {};
    default:
        return settings::valueText(item, model, value, settings::TextStyle::Typographic);
    }
}

QString displayValueWithUnit(const SettingItem& item, catalog::SensorModel model, Value value)
{
    const QString text = displayValue(item, model, value);
    const QString unit = settings::unitText(item);
    if (text.isEmpty() || unit.isEmpty() || item.kind == Kind::Choice || !sentinelText(item, value).isEmpty())
        return text;
    return text + QChar(QChar::Nbsp) + unit;
}

QString rangeText(const SettingItem& item, catalog::SensorModel model)
{
    if (item.kind == Kind::Choice)
        return choicesRange(choiceNames(item, model));
    const auto& limits = item.limitsFor(model);
    if (!item.isWritable() || limits.minimum == limits.maximum || item.kind == Kind::Trigger)
        return {};
    return displayValue(item, model, limits.minimum) + u' ' + ellipsis + u' ' +
           displayValue(item, model, limits.maximum);
}

QString defaultText(const SettingItem& item, catalog::SensorModel model)
{
    return item.hasDefault ? displayValue(item, model, item.limitsFor(model).defaultValue) : QString();
}

QStringList addressTexts(const SettingItem& item)
{
    QStringList texts;
    if (item.modbus) {
        texts +=
            item.registerCount() == 1
                ? Texts::tr("Modbus %1").arg(item.modbus->number)
                : Texts::tr("Modbus %1, %2 registers").arg(item.modbus->number).arg(item.registerCount());
    }
    if (item.eip)
        texts += Texts::tr("EtherNet/IP %1").arg(item.eip->attribute);
    if (item.slmp)
        texts += Texts::tr("SLMP D%1").arg(item.slmp->device);
    return texts;
}

QString octetsText(const QList<Value>& octets)
{
    QStringList parts;
    for (const Value octet : octets)
        parts += QString::number(octet);
    return parts.join(u'.');
}

} // namespace lds::ui

#include "value_report.h"

#include "measurement.h"
#include "value_text.h"

#include <QJsonArray>
#include <QJsonObject>

#include <algorithm>

namespace lds::ctl {

namespace {

using catalog::ItemId;
using catalog::SettingItem;

bool isKnown(const Target& target, const settings::Values& values)
{
    return std::ranges::all_of(target.items, [&values](ItemId item) { return values.contains(item); });
}

QString itemWords(const SettingItem& item, catalog::SensorModel model, catalog::Value value)
{
    for (const catalog::Choice& choice : item.choices) {
        if (choice.code == value)
            return QString::fromUtf8(choice.name);
    }
    if (item.id == ItemId::MeasuredValue && !sentinelWord(value).isEmpty())
        return sentinelWord(value);
    if (item.id == ItemId::PeakIntensity && value == catalog::sentinel::noIntensity)
        return sentinelWord(catalog::sentinel::indeterminate);
    if (item.kind == catalog::Kind::Bits)
        return QStringLiteral("0x%1").arg(quint16(value), 4, 16, QLatin1Char('0'));
    return settings::valueText(item, model, value);
}

} // namespace

QString sentinelWord(catalog::Value measuredValue)
{
    switch (measurement::kindOf(measuredValue)) {
    case measurement::ValueKind::Valid:
        return {};
    case measurement::ValueKind::Over:
        return QStringLiteral("over");
    case measurement::ValueKind::Under:
        return QStringLiteral("under");
    case measurement::ValueKind::Indeterminate:
        return QStringLiteral("indeterminate");
    case measurement::ValueKind::Alarm:
        return QStringLiteral("alarm");
    }
    return {};
}

QString valueWords(const Target& target, catalog::SensorModel model, const settings::Values& values)
{
    if (!isKnown(target, values))
        return {};
    QStringList parts;
    for (const ItemId item : target.items)
        parts += itemWords(catalog::hlG2(item), model, values.value(item));
    return parts.join(u'.');
}

QString unitOf(const Target& target, const settings::Values& values)
{
    const SettingItem& item = catalog::hlG2(target.items.first());
    const bool isWord = item.id == ItemId::MeasuredValue && !sentinelWord(values.value(item.id)).isEmpty();
    return isWord ? QString() : settings::unitText(item);
}

QJsonValue valueJson(const Target& target, catalog::SensorModel model, const settings::Values& values)
{
    if (!isKnown(target, values))
        return {};
    QJsonArray parts;
    for (const ItemId item : target.items)
        parts.append(values.value(item));
    return QJsonObject{{QStringLiteral("value"), target.isGroup() ? QJsonValue(parts) : parts.first()},
                       {QStringLiteral("text"), valueWords(target, model, values)},
                       {QStringLiteral("unit"), unitOf(target, values)}};
}

} // namespace lds::ctl

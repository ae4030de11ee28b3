#include "settings_text.h"

#include <QStringList>

namespace lds::settings::test {

namespace {

constexpr std::array groupOctets{
    std::array{ItemId::IpAddress1stOctet, ItemId::IpAddress2ndOctet, ItemId::IpAddress3rdOctet,
               ItemId::IpAddress4thOctet},
    std::array{ItemId::SubnetMask1stOctet, ItemId::SubnetMask2ndOctet, ItemId::SubnetMask3rdOctet,
               ItemId::SubnetMask4thOctet},
    std::array{ItemId::DefaultGateway1stOctet, ItemId::DefaultGateway2ndOctet, ItemId::DefaultGateway3rdOctet,
               ItemId::DefaultGateway4thOctet},
};

QString text(ItemId item, Value value)
{
    return QStringLiteral("%1=%2").arg(QLatin1StringView(catalog::hlG2(item).key)).arg(value);
}

} // namespace

QString text(const Values& values)
{
    QStringList parts;
    for (auto it = values.constBegin(); it != values.constEnd(); ++it)
        parts << text(it.key(), it.value());
    return parts.join(u' ');
}

QString text(const Write& write)
{
    QStringList parts;
    for (const ItemValue& each : write)
        parts << text(each.item, each.value);
    return parts.join(u' ');
}

QString text(const QList<Write>& steps)
{
    QStringList parts;
    for (const Write& step : steps)
        parts << text(step);
    return parts.join(QStringLiteral("; "));
}

QString text(const QList<Refusal>& refusals)
{
    QStringList parts;
    for (const Refusal& refusal : refusals) {
        QStringList items;
        for (const ItemId item : refusal.items)
            items << QString::fromLatin1(catalog::hlG2(item).key);
        parts << QStringLiteral("rule %1 (%2)").arg(int(refusal.rule)).arg(items.join(u' '));
    }
    return parts.join(QStringLiteral("; "));
}

Write addressWrite(catalog::WriteGroup group, const char* dotted)
{
    const QStringList parts = QString::fromLatin1(dotted).split(u'.');
    Write write;
    for (qsizetype i = 0; i < parts.size(); ++i)
        write << ItemValue{groupOctets[std::size_t(group) - 1][std::size_t(i)], parts[i].toInt()};
    return write;
}

Values address(catalog::WriteGroup group, const char* dotted)
{
    Values values;
    for (const ItemValue& each : addressWrite(group, dotted))
        values[each.item] = each.value;
    return values;
}

Values operator+(const Values& below, const Values& above)
{
    Values sum = below;
    sum.insert(above);
    return sum;
}

Values factorySettings(catalog::SensorModel model)
{
    Values values;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (item.role == catalog::Role::Setting && item.isWritable())
            values[item.id] = item.limitsFor(model).defaultValue;
    }
    return values;
}

} // namespace lds::settings::test

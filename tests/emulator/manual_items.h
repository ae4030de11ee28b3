#pragma once

#include "catalog.h"
#include "sensor_fixture.h"

#include <QList>
#include <QTest>

namespace lds::test {

/// Settings that one message can change by itself. Not: the four octets of an address, which only count
/// together, and brightness tuning, whose ON starts a procedure.
inline bool canBeChangedAlone(const catalog::SettingItem& item)
{
    return emulator::SettingsMemory::holds(item) && item.isWritable() && item.modbus &&
           item.role == catalog::Role::Setting && item.group == catalog::WriteGroup::None &&
           item.id != catalog::ItemId::BrightnessTuning;
}

/// A legal value of the item that is not its default and not refused beside the defaults of the others.
inline catalog::Value otherThanDefault(const catalog::SettingItem& item, catalog::SensorModel model)
{
    const catalog::Limits& limits = item.limitsFor(model);
    for (const catalog::Choice& choice : item.choices) {
        if (choice.code != limits.defaultValue && (choice.models & catalog::maskOf(model)))
            return choice.code;
    }
    const catalog::Value above = limits.defaultValue + limits.resolution;
    return above <= limits.maximum ? above : limits.defaultValue - limits.resolution;
}

inline QList<catalog::ItemId> settingsChangedAlone()
{
    QList<catalog::ItemId> found;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (canBeChangedAlone(item))
            found.append(item.id);
    }
    return found;
}

/// One row for each of `items`, by key.
inline void addRows(const QList<catalog::ItemId>& items)
{
    QTest::addColumn<int>("item");
    for (const catalog::ItemId id : items)
        QTest::addRow("%s", catalog::hlG2(id).key) << int(id);
}

/// 10.0.0.5/255.0.0.0 behind the gateway 10.0.0.1: none of the four octets as delivered, one message.
inline QList<emulator::ItemWrite> anotherNetwork()
{
    using enum catalog::ItemId;
    return {{IpAddress1stOctet, 10},     {IpAddress2ndOctet, 0},      {IpAddress3rdOctet, 0},
            {IpAddress4thOctet, 5},      {SubnetMask1stOctet, 255},   {SubnetMask2ndOctet, 0},
            {SubnetMask3rdOctet, 0},     {SubnetMask4thOctet, 0},     {DefaultGateway1stOctet, 10},
            {DefaultGateway2ndOctet, 0}, {DefaultGateway3rdOctet, 0}, {DefaultGateway4thOctet, 1}};
}

} // namespace lds::test

#include "command_effects.h"

#include "catalog.h"

namespace lds::sensor::command_effects {

namespace {

template <typename Condition>
QList<ItemId> readableItems(Condition condition)
{
    QList<ItemId> items;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (item.isReadable() && condition(item))
            items.append(item.id);
    }
    return items;
}

QList<ItemId> concerned(ItemId item, Value value, const settings::Values& held)
{
    switch (item) {
    case ItemId::BankSwitching:
        return QList{item, ItemId::TriggerInputCommunication, ItemId::HoldState} + bankScoped();
    case ItemId::BankCopy: {
        QList<ItemId> items{ItemId::TriggerInputCommunication, ItemId::HoldState};
        if (held.value(ItemId::BankSwitching) == copyDestination(value))
            items += bankScoped();
        return items;
    }
    case ItemId::SettingsInitialization:
        return readableItems([](const catalog::SettingItem&) { return true; });
    case ItemId::LaserStop:
    case ItemId::ZeroSetting:
        return {item, ItemId::SensorState};
    case ItemId::TriggerInputCommunication:
        return {item, ItemId::HoldState};
    case ItemId::ExecutionOfTeaching:
    case ItemId::Teaching1stPoint:
    case ItemId::Teaching2ndPoint:
    case ItemId::Teaching3rdPoint:
        return {ItemId::TeachingExecutionState, ItemId::HighSetValue, ItemId::LowSetValue};
    case ItemId::BrightnessTuning:
    case ItemId::BrightnessTuning1stPoint:
    case ItemId::BrightnessTuning2ndPoint:
        return {ItemId::BrightnessTuning, ItemId::BrightnessTuningExecutionState};
    default:
        return {item};
    }
}

} // namespace

QList<ItemId> readBack(ItemId item, Value value, const settings::Values& held)
{
    const QList<ItemId> wanted = concerned(item, value, held);
    return readableItems([&wanted](const catalog::SettingItem& each) { return wanted.contains(each.id); });
}

Saved savedAfter(Saved before, ItemId item)
{
    switch (item) {
    case ItemId::SetValueSaving:
        return Saved::Saved;
    case ItemId::SettingsInitialization:
        return Saved::Unknown;
    case ItemId::Teaching1stPoint:
    case ItemId::Teaching2ndPoint:
    case ItemId::Teaching3rdPoint:
    case ItemId::BrightnessTuning:
    case ItemId::BrightnessTuning1stPoint:
    case ItemId::BrightnessTuning2ndPoint:
        return Saved::NotSaved;
    default:
        return isStored(item) ? Saved::NotSaved : before;
    }
}

bool isStored(ItemId item)
{
    switch (item) {
    case ItemId::BankSwitching:
    case ItemId::ZeroSetting:
    case ItemId::LaserStop:
    case ItemId::KeyLock:
    case ItemId::BrightnessTuning:
        return true;
    default:
        return catalog::hlG2(item).role == catalog::Role::Setting;
    }
}

bool writesMemory(ItemId item)
{
    return item == ItemId::SetValueSaving || item == ItemId::BankCopy ||
           item == ItemId::SettingsInitialization;
}

Value copyDestination(Value code)
{
    const Value source = code / 3 + 1;
    const Value nth = code % 3 + 1; // among the other three, in ascending order
    return nth < source ? nth : nth + 1;
}

QList<ItemId> bankScoped()
{
    return readableItems([](const catalog::SettingItem& item) { return item.scope == catalog::Scope::Bank; });
}

} // namespace lds::sensor::command_effects

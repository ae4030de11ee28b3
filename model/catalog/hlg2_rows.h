#pragma once

// Shorthand for the rows of the HL-G2 catalog. Private to this folder: everybody else sees catalog.h.

#include "setting_item.h"

namespace lds::catalog::hlg2 {

using PerModel = std::array<Value, modelCount>;
using LimitsPerModel = std::array<Limits, modelCount>;

/// ± of the display and of HIGH, LOW and offset, in 0.1 µm (§4.3.7, §4.4.1).
inline constexpr PerModel displayLimit = {95'000, 950'000, 950'000, 950'000, 9'500'000};
/// The smallest step of a length setting, in 0.1 µm (§4.3.7, §4.4.1).
inline constexpr PerModel settingResolution = {1, 10, 10, 10, 100};

/// What a row says about an item in words.
struct Words {
    ItemId id;
    const char* key;
    int menu;
    const char* name;
    const char* section;
    const char* help;
};

/// What writing and reading it means.
struct Nature {
    Role role;
    Access access;
    Scope scope;
    Effect effect = Effect::AtOnce;
};
inline constexpr Nature bankSetting{Role::Setting, Access::ReadWrite, Scope::Bank};
inline constexpr Nature commonSetting{Role::Setting, Access::ReadWrite, Scope::Common};
inline constexpr Nature communicationSetting{Role::Setting, Access::ReadWrite, Scope::Common,
                                             Effect::AfterCommunicationReset};
/// Has a menu number but no address in any protocol (§2.2): only the sensor's keys reach it.
inline constexpr Nature keypadSetting{Role::Setting, Access::None, Scope::Common,
                                      Effect::AfterCommunicationReset};
inline constexpr Nature bankSwitch{Role::Switch, Access::ReadWrite, Scope::Bank};
inline constexpr Nature commonSwitch{Role::Switch, Access::ReadWrite, Scope::Common};
inline constexpr Nature bankProcedure{Role::Procedure, Access::ReadWrite, Scope::Bank};
inline constexpr Nature procedureStep{Role::Procedure, Access::Write, Scope::Common};
inline constexpr Nature command{Role::Command, Access::Write, Scope::Common};
inline constexpr Nature status{Role::Status, Access::Read, Scope::Common};

/// Size in bytes and the number of the item in each protocol as the manual prints it; 0 where there is none.
struct Where {
    int size = 0;
    int modbus = 0; ///< §5.2.4
    int slmp = 0;   ///< §5.4.4
    int eip = 0;    ///< §5.3.5
};

constexpr LimitsPerModel sameForAll(Limits limits) { return {limits, limits, limits, limits, limits}; }

/// Limits of a length, which the sensor rounds down to the setting resolution.
constexpr LimitsPerModel lengths(const PerModel& minimum, const PerModel& maximum, const PerModel& defaults)
{
    LimitsPerModel limits{};
    for (std::size_t model = 0; model < limits.size(); ++model)
        limits[model] = {minimum[model], maximum[model], defaults[model], settingResolution[model]};
    return limits;
}

constexpr PerModel negative(const PerModel& values)
{
    PerModel result{};
    for (std::size_t model = 0; model < result.size(); ++model)
        result[model] = -values[model];
    return result;
}

constexpr SettingItem row(const Words& words, const Nature& nature, Kind kind, const Where& where,
                          const LimitsPerModel& limits)
{
    SettingItem item{.id = words.id,
                     .key = words.key,
                     .menu = words.menu,
                     .name = words.name,
                     .help = words.help,
                     .section = words.section,
                     .role = nature.role,
                     .kind = kind,
                     .access = nature.access,
                     .scope = nature.scope,
                     .effect = nature.effect,
                     .size = where.size,
                     .limits = limits};
    // Commands and reports have nothing to go back to; steps of a procedure neither.
    item.hasDefault = nature.access == Access::ReadWrite || nature.access == Access::None;
    if (where.modbus)
        item.modbus = ModbusBinding{where.modbus};
    if (where.slmp)
        item.slmp = SlmpBinding{where.slmp};
    if (where.eip)
        item.eip = EipBinding{where.eip};
    return item;
}

/// An item with the same choices on every type.
constexpr SettingItem choice(const Words& words, const Nature& nature, const Where& where,
                             std::span<const Choice> choices, Value defaultCode = 0)
{
    SettingItem item = row(words, nature, Kind::Choice, where,
                           sameForAll({choices.front().code, choices.back().code, defaultCode}));
    item.choices = choices;
    return item;
}

/// An item that is executed by writing 0; every other value is reserved (§5.2.4 note 1).
constexpr SettingItem trigger(const Words& words, const Nature& nature, const Where& where)
{
    return row(words, nature, Kind::Trigger, where, sameForAll({0, 0, 0}));
}

/// The manual names no default for it.
constexpr SettingItem withoutDefault(SettingItem item)
{
    item.hasDefault = false;
    return item;
}

constexpr SettingItem inGroup(SettingItem item, WriteGroup group)
{
    item.group = group;
    return item;
}

inline constexpr Choice offOn[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "OFF")},
                                   {1, QT_TRANSLATE_NOOP("SettingItem", "ON")}};

// The rows by subject; hlg2_items.cpp puts them in the order of the register table.
std::span<const SettingItem> stateItems();
std::span<const SettingItem> commandItems();
std::span<const SettingItem> sensingItems();
std::span<const SettingItem> judgmentItems();
std::span<const SettingItem> teachingItems();
std::span<const SettingItem> systemItems();
std::span<const SettingItem> ethernetItems();
std::span<const SettingItem> serialItems();

} // namespace lds::catalog::hlg2

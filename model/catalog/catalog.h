#pragma once

#include "setting_item.h"

#include <QHash>
#include <QLatin1StringView>
#include <QStringView>

namespace lds::catalog {

/// One entry of the sensor's menu (§2.2): a heading, or a row with the items it sets.
struct MenuEntry {
    int number;                         ///< 1 … 96, 421, 422. Each digit is a level.
    const char* name;                   ///< Context "SettingItem".
    const char* section;                ///< The manual's section, "4.3.1".
    std::span<const ItemId> items = {}; ///< Empty for a heading; four for an IP address (1st octet first).
    constexpr int level() const { return number >= 100 ? 3 : number >= 10 ? 2 : 1; } ///< = bars shown
    constexpr int parent() const { return number / 10; }                             ///< 0 at the top
};

/// One bit of the sensor's state (§5.2.5); the same bits at the same places in every protocol: bit
/// (number − 1) % 16 of register 400011 + (number − 1) / 16.
struct Coil {
    int number;       ///< As the manual prints it, 1 … 64.
    const char* key;  ///< "alarm", "judgmentHigh", ...; empty for a reserved bit.
    const char* name; ///< Context "SettingItem".
    bool reserved() const { return *key == '\0'; }
};

/// What distinguishes the five types (§2.2, §4.4, §4.13); lengths in 0.1 µm.
struct ModelDescription {
    SensorModel model;
    const char* typeName;    ///< "HL-G203B-S-MK"
    int centerDistance;      ///< mm
    Value measurementRange;  ///< ± around the centre
    Value displayLimit;      ///< ± of the display and of HIGH, LOW, offset
    Value settingResolution; ///< 1, 10 or 100
    int decimals;            ///< Decimals of a length in mm at the setting resolution: 4, 3 or 2
};

/// Numbers the protocols share for a value that is none (§5.2.4 notes), in 0.1 µm.
namespace sentinel {
inline constexpr Value over = 9'600'000;
inline constexpr Value under = -9'600'000;
inline constexpr Value indeterminate = -9'999'999;
inline constexpr Value alarm = 9'999'999;
inline constexpr int noIntensity = 65535; ///< Peak intensity while indeterminate.
} // namespace sentinel

/// All items of a family in the order of its register table, and how to find one.
/// The functions are pure, take no locks and may be called from any thread.
class Catalog {
public:
    /// The HL-G2 communication type: 66 items with a Modbus register, 4 without any address.
    static const Catalog& hlG2();

    std::span<const SettingItem> items() const { return m_items; }
    std::span<const MenuEntry> menu() const { return m_menu; } ///< §2.2, in ascending tree order
    std::span<const Coil> coils() const { return m_coils; }    ///< §5.2.5, 1 … 64
    std::span<const ModelDescription> models() const { return m_models; }

    const SettingItem& item(ItemId id) const;
    const SettingItem* findByKey(QStringView key) const;           ///< nullptr when unknown
    const SettingItem* findByModbusAddress(quint16 address) const; ///< the item that starts there
    const MenuEntry* findMenu(int number) const;
    const ModelDescription& model(SensorModel model) const;
    const ModelDescription* findModel(QStringView typeName) const; ///< case-insensitive
    /// "Usage prohibited" in the register table (§5.2.4), e.g. 400051. `address` is the wire address.
    bool isUsageProhibited(quint16 address) const;

private:
    Catalog(std::span<const SettingItem> items, std::span<const MenuEntry> menu, std::span<const Coil> coils,
            std::span<const ModelDescription> models, std::span<const int> prohibited);

    std::span<const SettingItem> m_items;
    std::span<const MenuEntry> m_menu;
    std::span<const Coil> m_coils;
    std::span<const ModelDescription> m_models;
    std::span<const int> m_prohibited;
    QHash<quint16, const SettingItem*>
        m_byAddress; ///< Built once; a server asks for every register it is read.
};

/// Shorthand for Catalog::hlG2().item(id).
inline const SettingItem& hlG2(ItemId id) { return Catalog::hlG2().item(id); }

} // namespace lds::catalog

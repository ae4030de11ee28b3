#pragma once

#include "catalog.h"
#include "workpiece.h"

#include <array>
#include <QMap>

namespace lds::emulator {

/// The set values of one sensor: common ones once, those of §4.2 once for each bank, with the zero
/// correction beside them. A sensor has two of these: what it works with, and what it has saved.
class SettingsMemory {
public:
    static constexpr int bankCount = 4;

    /// Factory defaults of the model.
    explicit SettingsMemory(catalog::SensorModel model);

    /// Whether the item has a place in memory at all; commands, status and the trigger have none.
    static bool holds(const catalog::SettingItem& item);
    static bool isBanked(catalog::ItemId id);

    catalog::SensorModel model() const { return m_model; }
    int bank() const; ///< The bank in use, 0 … 3.

    catalog::Value value(catalog::ItemId id) const; ///< Of the bank in use.
    catalog::Value value(catalog::ItemId id, int bank) const;
    void setValue(catalog::ItemId id, catalog::Value value);
    void setValue(catalog::ItemId id, catalog::Value value, int bank);

    Nanometres zeroCorrection(int bank) const { return m_banks[std::size_t(bank)].zeroCorrection; }
    void setZeroCorrection(int bank, Nanometres correction);

    void copyBank(const SettingsMemory& source, int from, int to);
    void initializeBank(int bank);
    /// "All Areas" of §4.8.6: everything but language and communication, and back to bank 1.
    void initializeAllAreas();

    bool operator==(const SettingsMemory&) const = default;

private:
    struct Bank {
        QMap<catalog::ItemId, catalog::Value> values;
        Nanometres zeroCorrection = 0;
        bool operator==(const Bank&) const = default;
    };

    catalog::SensorModel m_model;
    QMap<catalog::ItemId, catalog::Value> m_common;
    std::array<Bank, bankCount> m_banks;
};

} // namespace lds::emulator

#pragma once

#include "catalog.h"
#include "light_receiver.h"

#include <array>
#include <optional>
#include <QMap>

namespace lds::emulator {

/// NPN/PNP setting, made when the sensor is first started (§3.6). It has no menu number and no address.
enum class InputPolarity : quint8 { Npn, Pnp };

/// The set values of one sensor: common ones once, those of §4.2 once for each bank, with the zero
/// correction and the tuned range of brightness beside them. A sensor has two of these: what it works with,
/// and what it has saved.
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

    /// Of brightness tuning (§4.3.3); nothing while it was never tuned.
    std::optional<BrightnessRange> tunedBrightness(int bank) const;
    void setTunedBrightness(int bank, std::optional<BrightnessRange> range);

    InputPolarity inputPolarity() const { return m_inputPolarity; }
    void setInputPolarity(InputPolarity polarity) { m_inputPolarity = polarity; }

    void copyBank(const SettingsMemory& source, int from, int to);
    void initializeBank(int bank);
    /// "All Areas" of §4.8.6: everything but language, NPN/PNP and communication, and back to bank 1.
    void initializeAllAreas();
    /// "Set value initialization" of §4.8.6: everything but communication.
    void initializeSetValues();

    bool operator==(const SettingsMemory&) const = default;

private:
    struct Bank {
        QMap<catalog::ItemId, catalog::Value> values;
        Nanometres zeroCorrection = 0;
        std::optional<BrightnessRange> tunedBrightness;
        bool operator==(const Bank&) const = default;
    };

    catalog::SensorModel m_model;
    QMap<catalog::ItemId, catalog::Value> m_common;
    std::array<Bank, bankCount> m_banks;
    InputPolarity m_inputPolarity = InputPolarity::Npn;
};

} // namespace lds::emulator

#include "hlg2_tables.h"

namespace lds::catalog::hlg2 {
namespace {

struct NamedCoil {
    int number;
    const char* key;
    const char* name;
};

// Register 400011 holds coils 1 to 16, 400012 17 to 32, 400013 33 to 48, 400014 49 to 64.
constexpr NamedCoil named[] = {
    {1, "alarm", QT_TRANSLATE_NOOP("SettingItem", "Alarm state")},
    {2, "indeterminate", QT_TRANSLATE_NOOP("SettingItem", "Data in an indeterminate state")},
    {3, "judgmentHigh", QT_TRANSLATE_NOOP("SettingItem", "Judgment output state (HI)")},
    {4, "judgmentGo", QT_TRANSLATE_NOOP("SettingItem", "Judgment output state (GO)")},
    {5, "judgmentLow", QT_TRANSLATE_NOOP("SettingItem", "Judgment output state (LO)")},
    {6, "judgmentHighTimerOff", QT_TRANSLATE_NOOP("SettingItem", "Judgment output state at timer OFF (HI)")},
    {7, "judgmentGoTimerOff", QT_TRANSLATE_NOOP("SettingItem", "Judgment output state at timer OFF (GO)")},
    {8, "judgmentLowTimerOff", QT_TRANSLATE_NOOP("SettingItem", "Judgment output state at timer OFF (LO)")},
    {9, "hold", QT_TRANSLATE_NOOP("SettingItem", "Hold state")},
    {10, "zeroSetting", QT_TRANSLATE_NOOP("SettingItem", "Zero setting state")},
    {11, "laser", QT_TRANSLATE_NOOP("SettingItem", "Laser state")},
    {12, "error", QT_TRANSLATE_NOOP("SettingItem", "Self-monitoring: Error")},
    {13, "caution", QT_TRANSLATE_NOOP("SettingItem", "Self-monitoring: Caution")},
    {14, "notification", QT_TRANSLATE_NOOP("SettingItem", "Self-monitoring: Notification")},
    {17, "excessiveIntensity", QT_TRANSLATE_NOOP("SettingItem", "Excessive intensity of received light")},
    {18, "insufficientIntensity",
     QT_TRANSLATE_NOOP("SettingItem", "Insufficient intensity of received light")},
    {19, "outsideMeasurementRange", QT_TRANSLATE_NOOP("SettingItem", "Outside the measurement range")},
    {20, "excessiveExtraneousLight", QT_TRANSLATE_NOOP("SettingItem", "Excessive extraneous light")},
    {33, "operationHoursExceeded", QT_TRANSLATE_NOOP("SettingItem", "Cumulative operation hours exceeded")},
    {34, "memoryWritesExceeded",
     QT_TRANSLATE_NOOP("SettingItem", "Number of writes to internal memory exceeded")},
    {49, "beamEmittingCircuitError", QT_TRANSLATE_NOOP("SettingItem", "Beam-emitting circuit error")},
    {51, "systemError", QT_TRANSLATE_NOOP("SettingItem", "System error")},
};

constexpr std::array<Coil, 64> withReserved()
{
    std::array<Coil, 64> all{};
    for (std::size_t bit = 0; bit < all.size(); ++bit)
        all[bit] = {int(bit) + 1, "", ""}; // Reserved; anything may be read there.
    for (const NamedCoil& coil : named)
        all[std::size_t(coil.number - 1)] = {coil.number, coil.key, coil.name};
    return all;
}

constexpr auto all = withReserved();

} // namespace

std::span<const Coil> coils() { return all; }

} // namespace lds::catalog::hlg2

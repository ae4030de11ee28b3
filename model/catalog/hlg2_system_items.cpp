#include "hlg2_rows.h"

namespace lds::catalog::hlg2 {
namespace {

constexpr Choice languages[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "English")},
                                {1, QT_TRANSLATE_NOOP("SettingItem", "Japanese")},
                                {2, QT_TRANSLATE_NOOP("SettingItem", "Simplified Chinese")}};

constexpr ModelMask fineType = maskOf(SensorModel::HlG203);
constexpr ModelMask coarseType = maskOf(SensorModel::HlG225);

constexpr Choice displayDigits[] = {
    {0, QT_TRANSLATE_NOOP("SettingItem", "4 digits (0.0001)"), fineType},
    {1, QT_TRANSLATE_NOOP("SettingItem", "3 digits (0.001)"), ModelMask(everyModel & ~coarseType)},
    {2, QT_TRANSLATE_NOOP("SettingItem", "2 digits (0.01)")},
    {3, QT_TRANSLATE_NOOP("SettingItem", "1 digit (0.1)")},
    {4, QT_TRANSLATE_NOOP("SettingItem", "0 digits (1)"), ModelMask(everyModel & ~fineType)}};

/// Every type starts with as many digits as it has and can leave out three of them at most (§4.8.1).
constexpr LimitsPerModel displayDigitLimits = {Limits{0, 3, 0}, Limits{1, 4, 1}, Limits{1, 4, 1},
                                               Limits{1, 4, 1}, Limits{2, 4, 2}};

constexpr SettingItem displayDigitRow()
{
    SettingItem item = row(
        {ItemId::DisplayDigit, "displayDigit", 91, QT_TRANSLATE_NOOP("SettingItem", "Display digit"), "4.8.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "How many decimals the sensor's display shows of the measured value; the rest is cut off, "
             "not rounded. Judgment and communication keep all digits, so what is shown may seem to "
             "contradict HI, GO or LO. One value for each bank.")},
        bankSetting, Kind::Choice, {1, 400111, 110, 2325}, displayDigitLimits);
    item.choices = displayDigits;
    return item;
}

constexpr Choice orientations[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Default")},
                                   {1, QT_TRANSLATE_NOOP("SettingItem", "Inverted")}};

/// The sensor's own display and language (§4.8).
constexpr SettingItem rows[] = {
    choice({ItemId::LanguageSetting, "languageSetting", 94,
            QT_TRANSLATE_NOOP("SettingItem", "Language setting"), "4.8.4",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "The language of the sensor's own display. It has nothing to do with the language of this "
                "program, and initializing All Areas leaves it alone.")},
           commonSetting, {1, 400071, 70, 2321}, languages),
    choice({ItemId::EcoMode, "ecoMode", 92, QT_TRANSLATE_NOOP("SettingItem", "Eco mode"), "4.8.2",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "ON switches the sensor's display off when no key was pressed for 180 seconds, which makes "
                "it last longer; OFF only dims it and lets it blink. A key brings it back, a "
                "communication command does not. Measuring goes on either way.")},
           commonSetting, {1, 400109, 108, 2323}, offOn, 1),
    displayDigitRow(),
    choice({ItemId::DisplayInversion, "displayInversion", 93,
            QT_TRANSLATE_NOOP("SettingItem", "Display inversion"), "4.8.3",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Turns the sensor's display upside down for a sensor mounted the other way up. The UP and "
                "DOWN keys change places with it.")},
           commonSetting, {1, 400112, 111, 2326}, orientations),
};

} // namespace

std::span<const SettingItem> systemItems() { return rows; }

} // namespace lds::catalog::hlg2

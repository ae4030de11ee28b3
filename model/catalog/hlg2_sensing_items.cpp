#include "hlg2_rows.h"

namespace lds::catalog::hlg2 {
namespace {

constexpr Choice samplingFrequencies[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "100 µs")},
                                          {1, QT_TRANSLATE_NOOP("SettingItem", "200 µs")},
                                          {2, QT_TRANSLATE_NOOP("SettingItem", "500 µs")},
                                          {3, QT_TRANSLATE_NOOP("SettingItem", "1 ms")},
                                          {4, QT_TRANSLATE_NOOP("SettingItem", "2 ms")}};

constexpr Choice averageTimes[] = {
    {0, QT_TRANSLATE_NOOP("SettingItem", "1 time")},    {1, QT_TRANSLATE_NOOP("SettingItem", "4 times")},
    {2, QT_TRANSLATE_NOOP("SettingItem", "16 times")},  {3, QT_TRANSLATE_NOOP("SettingItem", "64 times")},
    {4, QT_TRANSLATE_NOOP("SettingItem", "256 times")}, {5, QT_TRANSLATE_NOOP("SettingItem", "512 times")},
    {6, QT_TRANSLATE_NOOP("SettingItem", "1024 times")}};

constexpr Choice holdModes[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "None (Normal mode)")},
                                {1, QT_TRANSLATE_NOOP("SettingItem", "Peak Hold")},
                                {2, QT_TRANSLATE_NOOP("SettingItem", "Bottom Hold")},
                                {3, QT_TRANSLATE_NOOP("SettingItem", "Peak to Peak Hold")}};

constexpr Choice directions[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Normal")},
                                 {1, QT_TRANSLATE_NOOP("SettingItem", "Reverse")}};

constexpr Choice triggerModes[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Hold")},
                                   {1, QT_TRANSLATE_NOOP("SettingItem", "One Shot")}};

/// How a value is obtained: sensing (§4.3) and the trigger that holds it (§4.6.2).
constexpr SettingItem rows[] = {
    choice({ItemId::SamplingFrequency, "samplingFrequency", 21,
            QT_TRANSLATE_NOOP("SettingItem", "Sampling frequency"), "4.3.1",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Time from one sample to the next. Short for fast workpieces; longer for dark ones such "
                "as black rubber, which need the light, and some surfaces narrow the measurement range "
                "at short times. Tune the brightness again after changing it. One value for each bank.")},
           bankSetting, {2, 400113, 112, 2327}, samplingFrequencies, 3),
    choice({ItemId::AverageTimes, "averageTimes", 22, QT_TRANSLATE_NOOP("SettingItem", "Average times"),
            "4.3.2",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "How many samples the moving average takes in. Few follow quick changes, many smooth "
                "them out. After a change there is no value until enough samples are gathered again. "
                "One value for each bank.")},
           bankSetting, {2, 400114, 113, 2328}, averageTimes, 5),
    choice({ItemId::HoldMode, "holdMode", 24, QT_TRANSLATE_NOOP("SettingItem", "Hold mode"), "4.3.4",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "What is kept while the trigger works: the value itself, its highest, its lowest, or "
                "the difference of the two. Anything but None turns the trigger mode One Shot into Hold, "
                "and teaching and brightness tuning start only with None. One value for each bank.")},
           bankSetting, {2, 400115, 114, 2329}, holdModes),
    row({ItemId::Span, "span", 26, QT_TRANSLATE_NOOP("SettingItem", "Span"), "4.3.6",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "Factor for the measured value: final value = span × value after zero setting + offset. "
             "HIGH and LOW judge the final value, so look at them again after changing it. One value "
             "for each bank.")},
        bankSetting, Kind::Factor, {4, 400116, 115, 2330}, sameForAll({1'000, 99'999, 10'000})),
    row({ItemId::Offset, "offset", 27, QT_TRANSLATE_NOOP("SettingItem", "Offset"), "4.3.7",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "Added after the span: final value = span × value after zero setting + offset. With zero "
             "setting ON, the reference workpiece reads as this value. One value for each bank.")},
        bankSetting, Kind::Length, {4, 400118, 117, 2331}, lengths(negative(displayLimit), displayLimit, {})),
    // §4.2 does not list the inversion among the settings a bank holds.
    choice({ItemId::InversionOfMeasuredValue, "inversionOfMeasuredValue", 25,
            QT_TRANSLATE_NOOP("SettingItem", "Inversion of measured value"), "4.3.5",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Normal counts up when the workpiece comes nearer, Reverse counts down. HIGH, LOW and "
                "the zero correction keep their signs, so check the judgment and set the zero again "
                "after a change. One value for all banks.")},
           commonSetting, {1, 400124, 123, 2335}, directions),
    choice({ItemId::TriggerMode, "triggerMode", 53, QT_TRANSLATE_NOOP("SettingItem", "Trigger mode"), "4.6.2",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Hold freezes the value as long as the trigger is ON; One Shot takes a new value each "
                "time the trigger goes ON and keeps it. One Shot needs hold mode None. A change clears a "
                "trigger given over communication and makes the value indeterminate. One value for each "
                "bank.")},
           bankSetting, {1, 400130, 129, 2340}, triggerModes),
};

} // namespace

std::span<const SettingItem> sensingItems() { return rows; }

} // namespace lds::catalog::hlg2

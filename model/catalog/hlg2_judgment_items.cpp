#include "hlg2_rows.h"

namespace lds::catalog::hlg2 {
namespace {

constexpr PerModel judgmentDefault = {50'000, 100'000, 200'000, 300'000, 1'500'000};

constexpr Choice outputDelays[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "OFF (No timer)")},
                                   {1, QT_TRANSLATE_NOOP("SettingItem", "On Delay")},
                                   {2, QT_TRANSLATE_NOOP("SettingItem", "Off Delay")},
                                   {3, QT_TRANSLATE_NOOP("SettingItem", "One Shot")},
                                   {4, QT_TRANSLATE_NOOP("SettingItem", "Hold")}};

constexpr Choice alarmOutputs[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Hold")},
                                   {1, QT_TRANSLATE_NOOP("SettingItem", "Alarm")}};

/// What a value is judged by and what becomes of the judgment: §4.4, §4.5 and the alarm, §4.7.
constexpr SettingItem rows[] = {
    row({ItemId::HighSetValue, "highSetValue", 31, QT_TRANSLATE_NOOP("SettingItem", "HIGH set value"),
         "4.4.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "Upper limit of the judgment: a final value above it is HIGH, at or below it GO. It has to "
             "be above LOW, and HIGH minus LOW has to be more than twice the hysteresis, else the sensor "
             "refuses it. Teaching can set it from real workpieces. One value for each bank.")},
        bankSetting, Kind::Length, {4, 400101, 100, 2318},
        lengths(negative(displayLimit), displayLimit, judgmentDefault)),
    row({ItemId::LowSetValue, "lowSetValue", 32, QT_TRANSLATE_NOOP("SettingItem", "LOW set value"), "4.4.2",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "Lower limit of the judgment: a final value below it is LOW, at or above it GO. It has to be "
             "below HIGH, and HIGH minus LOW has to be more than twice the hysteresis, else the sensor "
             "refuses it. Teaching can set it from real workpieces. One value for each bank.")},
        bankSetting, Kind::Length, {4, 400103, 102, 2319},
        lengths(negative(displayLimit), displayLimit, negative(judgmentDefault))),
    // §4.4.3 prints 0.1 µm for 30 mm to 120 mm in one cell, but gives the range and the default of the middle
    // types three decimals like every other length; their setting resolution of 1 µm is taken.
    row({ItemId::Hysteresis, "hysteresis", 33, QT_TRANSLATE_NOOP("SettingItem", "Hysteresis"), "4.4.3",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "How far the value has to come back before the judgment changes again; more of it keeps the "
             "outputs from chattering when the workpiece shakes near a limit. Twice the hysteresis has to "
             "be less than HIGH minus LOW. If it is not below the tolerance, 1 point teaching may fail. "
             "One value for each bank.")},
        bankSetting, Kind::Length, {4, 400105, 104, 2320},
        lengths({}, displayLimit, {100, 200, 400, 600, 3'000})),
    row({ItemId::Tolerance, "tolerance", 35, QT_TRANSLATE_NOOP("SettingItem", "Tolerance"), "4.4.5",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "Used by 1 point teaching only: HIGH becomes the master's value plus this, LOW the master's "
             "value minus it. It has to be greater than the hysteresis. Changing it does not move HIGH "
             "and LOW: teach again. One value for each bank.")},
        bankSetting, Kind::Length, {4, 400120, 119, 2332},
        lengths(settingResolution, displayLimit, {20'000, 50'000, 100'000, 150'000, 1'000'000})),
    choice({ItemId::OutputDelayTimerSelection, "outputDelayTimerSelection", 421,
            QT_TRANSLATE_NOOP("SettingItem", "Output delay timer selection"), "4.5.1",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "How the judgment outputs react: at once, late when going ON, late when going OFF, as one "
                "pulse of fixed length, or ON until the measured value is reset. Judgments shorter than "
                "the timer's time do not show with On Delay and Off Delay. One value for each bank.")},
           bankSetting, {1, 400122, 121, 2333}, outputDelays),
    row({ItemId::OutputDelayTimerSetting, "outputDelayTimerSetting", 422,
         QT_TRANSLATE_NOOP("SettingItem", "Output delay timer setting"), "4.5.2",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The timer's time for On Delay, Off Delay and One Shot; OFF and Hold do not use it. A change "
             "during a running delay counts from the next change of the output. One value for each "
             "bank.")},
        bankSetting, Kind::Duration, {2, 400123, 122, 2334}, sameForAll({1, 100, 1})),
    row({ItemId::AlarmDelayCount, "alarmDelayCount", 63,
         QT_TRANSLATE_NOOP("SettingItem", "Alarm delay count"), "4.7.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "How many unmeasurable samples in a row it takes to raise an alarm; until then the last value "
             "is held. The delay is this count times the sampling time. 0 never raises an alarm. One "
             "value for each bank.")},
        bankSetting, Kind::Count, {2, 400110, 109, 2324}, sameForAll({0, 65'535, 8})),
    choice({ItemId::AlarmDigitalOutput, "alarmDigitalOutput", 62,
            QT_TRANSLATE_NOOP("SettingItem", "Alarm digital output"), "4.7.2",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "What display and communication give during an alarm: Hold repeats the last value, Alarm "
                "says so plainly (ALARM, +9999999). With Hold a frozen number can look like a good one: "
                "watch the alarm flag. One value for each bank.")},
           bankSetting, {1, 400125, 124, 2336}, alarmOutputs),
};

} // namespace

std::span<const SettingItem> judgmentItems() { return rows; }

} // namespace lds::catalog::hlg2

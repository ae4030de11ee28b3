#include "hlg2_rows.h"

namespace lds::catalog::hlg2 {
namespace {

constexpr LimitsPerModel sixteenBits = sameForAll({0, 0xffff, 0});

constexpr Choice holdStates[] = {{0, QT_TRANSLATE_NOOP("SettingItem", "Release")},
                                 {1, QT_TRANSLATE_NOOP("SettingItem", "Hold")}};

/// What the sensor reports. The limits admit everything that can be read, the sentinels of §5.2.4 included.
constexpr SettingItem rows[] = {
    row({ItemId::SensorState, "sensorState", 0, QT_TRANSLATE_NOOP("SettingItem", "Sensor state"), "5.2.5",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "Sixteen flags that tell how things stand now: alarm, indeterminate value, HI, GO and "
             "LO with and without the output delay timer, hold, zero setting, laser, and whether "
             "self-monitoring has something to say.")},
        status, Kind::Bits, {2, 400011, 10, 2304}, sixteenBits),
    row({ItemId::SelfMonitoringNotification, "selfMonitoringNotification", 0,
         QT_TRANSLATE_NOOP("SettingItem", "Self-monitoring detail: Notification"), "4.13",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "Why the sensor reports a notification: too much or too little received light, too much "
             "light from elsewhere, or a workpiece outside the measurement range. It clears by "
             "itself when the cause is gone.")},
        status, Kind::Bits, {2, 400012, 11, 2305}, sixteenBits),
    row({ItemId::SelfMonitoringCaution, "selfMonitoringCaution", 0,
         QT_TRANSLATE_NOOP("SettingItem", "Self-monitoring detail: Caution"), "4.13",
         QT_TRANSLATE_NOOP("SettingItem",
                           "Why the sensor reports a caution: its operating hours or the number of times its "
                           "memory was written are past what it is made for. Plan a replacement.")},
        status, Kind::Bits, {2, 400013, 12, 2306}, sixteenBits),
    row({ItemId::SelfMonitoringError, "selfMonitoringError", 0,
         QT_TRANSLATE_NOOP("SettingItem", "Self-monitoring detail: Error"), "4.13",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "Why the sensor reports an error: the laser circuit or the system itself has failed. "
             "Look at the error code, check the wiring, and replace the sensor if a restart does "
             "not help.")},
        status, Kind::Bits, {2, 400014, 13, 2307}, sixteenBits),
    row({ItemId::ErrorCode, "errorCode", 0, QT_TRANSLATE_NOOP("SettingItem", "Error code"), "8.2",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The number the sensor's display shows behind the E when something has failed, without "
             "its two internal digits. 0 when all is well.")},
        status, Kind::ErrorCode, {2, 400015, 14, 2308}, sixteenBits),
    row({ItemId::MeasuredValue, "measuredValue", 0, QT_TRANSLATE_NOOP("SettingItem", "Measured value"),
         "5.2.4",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "The final value after averaging, zero setting, span, offset and hold, in steps of "
             "0.1 µm on every type. Four reserved numbers stand for over range, under range, "
             "indeterminate and alarm.")},
        status, Kind::Length, {4, 400020, 19, 2311}, sameForAll({-9'999'999, 9'999'999, 0})),
    row({ItemId::PeakIntensity, "peakIntensity", 0,
         QT_TRANSLATE_NOOP("SettingItem", "Peak intensity of received light"), "4.1",
         QT_TRANSLATE_NOOP(
             "SettingItem",
             "How strong the peak of the received light is, from 0 to 1023. 65535 means that there "
             "is no value because the measurement is indeterminate.")},
        status, Kind::Count, {2, 400022, 21, 0}, sixteenBits),
    choice(
        {ItemId::TriggerInputExternal, "triggerInputExternal", 0,
         QT_TRANSLATE_NOOP("SettingItem", "Trigger input (external input)"), "4.6.2",
         QT_TRANSLATE_NOOP("SettingItem",
                           "Whether the trigger wire IN1 is active now. Useful to check the wiring and the "
                           "NPN/PNP setting; the input has to last at least 2 ms to count.")},
        status, {1, 400128, 127, 2338}, offOn),
    // The SLMP table prints "Hold mode" for device 128; its description and the other tables say hold state.
    choice({ItemId::HoldState, "holdState", 0, QT_TRANSLATE_NOOP("SettingItem", "Hold state"), "4.6.2",
            QT_TRANSLATE_NOOP(
                "SettingItem",
                "Whether the measured value is being held by a trigger at this moment. While it is "
                "held, the number does not follow the workpiece.")},
           status, {1, 400129, 128, 2339}, holdStates),
};

} // namespace

std::span<const SettingItem> stateItems() { return rows; }

} // namespace lds::catalog::hlg2

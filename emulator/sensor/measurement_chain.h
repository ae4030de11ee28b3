#pragma once

#include "workpiece.h"

#include <optional>
#include <vector>

namespace lds::emulator {

enum class HoldMode : quint8 {
    None = 0,
    Peak = 1,
    Bottom = 2,
    PeakToPeak = 3
};                                                         ///< §4.3.4, codes as on the wire
enum class TriggerMode : quint8 { Hold = 0, OneShot = 1 }; ///< §4.6.2

/// The settings that make a measured value out of what the sensor sees, in the chain's own units.
struct ChainSettings {
    int averageTimes = 512;
    bool inverted = false;
    std::optional<Nanometres> zeroCorrection; ///< Nothing while zero setting is OFF.
    int span = 10'000;                        ///< 1/10000
    Nanometres offset = 0;
    Nanometres high = 0;
    Nanometres low = 0;
    Nanometres hysteresis = 0;
    HoldMode holdMode = HoldMode::None;
    TriggerMode triggerMode = TriggerMode::Hold;
    int alarmDelayCount = 8; ///< Samples; 0 = no alarm is reported (§4.7.1)
    bool alarmShown = false; ///< Alarm digital output on Alarm, not on Hold (§4.7.2)
    bool operator==(const ChainSettings&) const = default;
};

enum class Judgment : quint8 { None, High, Go, Low };

/// From reflections to the final measured value, one sample at a time:
/// moving average → inversion → zero → span × value + offset → hold and trigger → judgment.
/// Output delay timers (§4.5) are not in this version: the two sets of judgment bits are the same.
class MeasurementChain {
public:
    void setSettings(const ChainSettings& settings);
    void sample(const Reflection& reflection, bool laserEmitting, bool trigger);
    /// Forgets the average, what is held and the judgment: indeterminate until the average is full again.
    void restart();
    /// Lets `reflection` stand there until the average is full of it.
    void settle(const Reflection& reflection, bool trigger);

    std::optional<Nanometres> value() const { return m_output; } ///< Nothing while indeterminate.
    bool alarm() const { return m_alarm; }
    /// The alarm is to be seen in place of the value.
    bool alarmShown() const { return m_alarm && m_settings.alarmShown; }
    bool holding() const { return m_holding; }
    bool measurable() const { return m_reflection.light == Light::Measurable; }
    Judgment judgment() const { return alarmShown() ? Judgment::None : m_judgment; }
    const Reflection& reflection() const { return m_reflection; }
    /// The averaged, inverted value before zero setting: what zero setting makes the new zero (§4.10).
    std::optional<Nanometres> beforeZero() const;

private:
    void average(Nanometres distance);
    std::optional<Nanometres> corrected() const;
    void hold(std::optional<Nanometres> now, bool trigger);
    void holdExtremes(std::optional<Nanometres> now, bool trigger, bool released);
    void judge();

    ChainSettings m_settings;
    Reflection m_reflection;
    std::vector<Nanometres> m_ring = std::vector<Nanometres>(512, 0);
    std::size_t m_next = 0;
    std::size_t m_filled = 0;
    Nanometres m_sum = 0;
    int m_unmeasurable = 0; ///< Samples in a row.
    bool m_alarm = false;
    bool m_trigger = false;
    bool m_holding = false;
    std::optional<Nanometres> m_highest;
    std::optional<Nanometres> m_lowest;
    std::optional<Nanometres> m_output;
    Judgment m_judgment = Judgment::None;
};

} // namespace lds::emulator

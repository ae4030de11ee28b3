#pragma once

#include "output_delay_timer.h"
#include "reflection.h"

#include <array>
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
    OutputDelaySettings outputDelay;
    bool operator==(const ChainSettings&) const = default;
};

enum class Judgment : quint8 { None, High, Go, Low };

/// The outputs of a judgment behind their output delay timers (§4.5). More than one may be ON.
struct JudgmentOutputs {
    bool high = false;
    bool go = false;
    bool low = false;
    bool operator==(const JudgmentOutputs&) const = default;
};

/// From reflections to the final measured value, one sample at a time:
/// moving average → inversion → zero → span × value + offset → alarm → hold and trigger → judgment →
/// output delay timers.
///
/// Hold and trigger hold the *final* measured value (§1.4, §4.6.2): whether it was an alarm is held with it.
/// Times are nanoseconds of one monotonic clock and never go back.
class MeasurementChain {
public:
    void setSettings(const ChainSettings& settings);
    void sample(const Reflection& reflection, bool laserEmitting, bool trigger, qint64 timeNs);
    /// Between samples: a setting, the trigger or the laser has changed.
    void refresh(bool laserEmitting, bool trigger, qint64 timeNs);
    /// Lets output delay timers run out.
    void advance(qint64 timeNs);
    /// Forgets the average, what is held and the judgment: indeterminate until the average is full again.
    void restart();
    /// Measured value resetting (§4.11): a restart that turns the judgment outputs OFF as well.
    void reset();
    /// Lets `reflection` stand there until the average is full of it.
    void settle(const Reflection& reflection, bool trigger, qint64 timeNs);

    std::optional<Nanometres> value() const { return m_output.value; } ///< Nothing while indeterminate.
    /// The measured value is that of an alarm, or the last one before it (§4.7.2).
    bool alarm() const { return m_output.alarm; }
    /// The alarm is to be seen in place of the value.
    bool alarmShown() const { return m_output.alarm && m_settings.alarmShown && !m_blank; }
    /// An unmeasurable state has lasted longer than the alarm delay count, whatever is held (§4.13).
    bool alarmNow() const { return m_live.alarm; }
    bool holding() const { return m_holding; }
    bool measurable() const { return m_reflection.light == Light::Measurable; }
    /// Without output delay timers (§5.2.5, "at timer OFF").
    Judgment judgment() const { return m_judgment; }
    JudgmentOutputs outputs() const;
    const Reflection& reflection() const { return m_reflection; }
    /// The averaged, inverted value before zero setting: what zero setting makes the new zero (§4.10).
    std::optional<Nanometres> beforeZero() const;

private:
    /// A value as it is measured or held: nothing is "indeterminate".
    struct Final {
        std::optional<Nanometres> value;
        bool alarm = false;
        bool isThere() const { return value || alarm; }
    };

    void average(Nanometres distance);
    void countUnmeasurable();
    std::optional<Nanometres> corrected() const;
    void hold(bool trigger);
    void holdExtremes(bool trigger, bool released);
    Judgment judged() const;
    void judge(qint64 timeNs);

    ChainSettings m_settings;
    Reflection m_reflection;
    std::vector<Nanometres> m_ring = std::vector<Nanometres>(512, 0);
    std::size_t m_next = 0;
    std::size_t m_filled = 0;
    Nanometres m_sum = 0;
    int m_unmeasurable = 0; ///< Samples in a row.
    bool m_trigger = false;
    bool m_holding = false;
    bool m_blank = false; ///< §4.7.2 note 1: indeterminate until light comes back.
    Final m_live;         ///< Before hold.
    Final m_output;       ///< After it.
    std::optional<Nanometres> m_highest;
    std::optional<Nanometres> m_lowest;
    Judgment m_judgment = Judgment::None;
    std::array<OutputDelayTimer, 3> m_timers; ///< HI, GO, LO
    qint64 m_timeNs = 0;
};

} // namespace lds::emulator

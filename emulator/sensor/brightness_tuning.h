#pragma once

#include "light_receiver.h"
#include "operator_kind.h"

#include <optional>

namespace lds::emulator {

/// As register 400144.
enum class TuningState : quint8 { NotExecuted = 0, FirstPoint = 1, SecondPoint = 2, Success = 3, Failed = 4 };

/// Brightness tuning with two workpieces of different brightness (§4.3.3): adjusts to one after the other
/// and finds the range of laser brightness that both need.
class BrightnessTuning {
public:
    /// The manual says "stably for a certain period of time" and gives no figures; these are chosen.
    static constexpr qint64 stableNs = 50'000'000;
    static constexpr qint64 longestNs = 1'000'000'000;

    TuningState state() const { return m_state; }
    bool isExecuting() const
    {
        return m_state == TuningState::FirstPoint || m_state == TuningState::SecondPoint;
    }
    bool isAdjusting() const { return m_startedNs.has_value(); }
    Operator operatedBy() const { return m_operator; }
    int nextPoint() const; ///< 1 or 2; 0 when none can be taken now.

    void start(Operator by);
    void interrupt(); ///< Back to "not executed", from any state.
    /// Begins to adjust to the workpiece that stands there now.
    void take(qint64 nowNs);
    void fail(); ///< Alarm, indeterminate or hold state.
    /// One sample while adjusting. Answers with the range when the second point has succeeded.
    std::optional<BrightnessRange> sample(const LightReceiver& receiver, qint64 timeNs);

private:
    TuningState m_state = TuningState::NotExecuted;
    Operator m_operator = Operator::Communication;
    std::optional<qint64> m_startedNs; ///< Adjusting since.
    qint64 m_optimalSinceNs = 0;
    int m_first = 0; ///< Brightness for the first workpiece.
};

} // namespace lds::emulator

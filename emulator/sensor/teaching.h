#pragma once

#include "catalog.h"
#include "lengths.h"
#include "operator_kind.h"

#include <optional>
#include <QList>

namespace lds::emulator {

enum class TeachingState : quint8 { NotExecuted = 0, Executing = 1, Success = 2, Failed = 3 }; ///< As 400133.

/// What the sensor measures when a point is taught.
struct TeachingTarget {
    std::optional<Nanometres> value; ///< The final measured value; nothing while indeterminate.
    bool alarm = false;
    bool outsideDisplay = false; ///< +OVER or -OVER is displayed.
    bool holding = false;
};

/// The settings that teaching depends on, in wire units.
struct TeachingConditions {
    catalog::Value tolerance = 0;
    catalog::Value hysteresis = 0;
    catalog::Value minimum = 0; ///< Of the setting range of HIGH and LOW.
    catalog::Value maximum = 0;
    catalog::Value resolution = 1; ///< Setting resolution of the type.
};

struct TaughtWindow {
    catalog::Value high; ///< Wire units.
    catalog::Value low;
    bool operator==(const TaughtWindow&) const = default;
};

/// 1, 2 and 3 points teaching (§4.9): which point is next, when it fails, and the window it finds.
class Teaching {
public:
    TeachingState state() const { return m_state; }
    bool isExecuting() const { return m_state == TeachingState::Executing; }
    Operator operatedBy() const { return m_operator; }
    int points() const { return m_points; }
    int nextPoint() const { return isExecuting() ? int(m_values.size()) + 1 : 0; } ///< 1 … points(); 0: none.

    void start(int points, Operator by);
    void interrupt(); ///< Back to "not executed", from any state.
    /// Takes the next point. The last one brings a window or failure; an earlier one may bring failure.
    std::optional<TaughtWindow> take(const TeachingTarget& target, const TeachingConditions& conditions);

private:
    std::optional<TaughtWindow> window(const TeachingConditions& conditions) const;

    TeachingState m_state = TeachingState::NotExecuted;
    Operator m_operator = Operator::Communication;
    int m_points = 0;
    QList<Nanometres> m_values;
};

} // namespace lds::emulator

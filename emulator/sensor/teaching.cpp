#include "teaching.h"

#include <algorithm>

namespace lds::emulator {

using catalog::Value;

namespace {

/// In steps of the setting resolution; what is less becomes 0 (§4.9).
Value atResolution(Nanometres length, const TeachingConditions& conditions)
{
    const Nanometres step = conditions.resolution * nanometresPerWireUnit;
    return Value(length / step * conditions.resolution);
}

bool hasTwoAlike(const QList<Value>& values)
{
    QList<Value> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

} // namespace

void Teaching::start(int points, Operator by)
{
    m_state = TeachingState::Executing;
    m_operator = by;
    m_points = points;
    m_values.clear();
}

void Teaching::interrupt()
{
    m_state = TeachingState::NotExecuted;
    m_values.clear();
}

std::optional<TaughtWindow> Teaching::take(const TeachingTarget& target, const TeachingConditions& conditions)
{
    if (!isExecuting())
        return std::nullopt;
    if (!target.value || target.alarm || target.outsideDisplay || target.holding) {
        m_state = TeachingState::Failed;
        return std::nullopt;
    }
    m_values.append(*target.value);
    if (m_values.size() < m_points)
        return std::nullopt;
    const auto found = window(conditions);
    m_state = found ? TeachingState::Success : TeachingState::Failed;
    return found;
}

std::optional<TaughtWindow> Teaching::window(const TeachingConditions& conditions) const
{
    QList<Nanometres> sorted = m_values;
    std::sort(sorted.begin(), sorted.end());
    QList<Value> shown;
    for (const Nanometres value : sorted)
        shown.append(atResolution(value, conditions));
    if (hasTwoAlike(shown))
        return std::nullopt;
    Nanometres high = sorted.last();
    Nanometres low = sorted.first();
    if (m_points == 1) { // §4.9.1: and the setting range is not left
        high += conditions.tolerance * nanometresPerWireUnit;
        low -= conditions.tolerance * nanometresPerWireUnit;
    } else if (m_points == 3) { // §4.9.3: half way to the median
        high = (sorted.at(2) + sorted.at(1)) / 2;
        low = (sorted.at(0) + sorted.at(1)) / 2;
    }
    const TaughtWindow found{std::min(atResolution(high, conditions), conditions.maximum),
                             std::max(atResolution(low, conditions), conditions.minimum)};
    if (qint64(found.high) - found.low <= 2 * qint64(conditions.hysteresis))
        return std::nullopt;
    return found;
}

} // namespace lds::emulator

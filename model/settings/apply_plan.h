#pragma once

#include "rules.h"

namespace lds::settings {

/// Ordered writes from `current` to `wanted`, each one accepted by the rules in turn (§4.4.1, §5.1.1).
struct ApplyPlan {
    QList<Write> steps;
};

/// Why there is no order of writes: the goal itself breaks a rule, or the sensor stands in a state it
/// would not have let anybody write and that no single write leads out of (then these are its refusals).
struct PlanFailure {
    QList<Refusal> refusals; ///< Never empty.
};

/// The rules the sensor would hold against these changes, whatever the order: those that the items to be
/// changed touch, judged at the goal; the tolerance against the smaller of the present and the wanted
/// hysteresis, since it may be written before the hysteresis grows (§4.4.5). Empty when there are none;
/// then planWrites() finds a way from every state the rules allow.
QList<Refusal> goalProblems(catalog::SensorModel model, const Values& current, const Values& wanted);

/// Plans the writes that take the sensor from `current` to `current` overlaid with `wanted`.
/// Widens the judgment window before moving it, sets the gateway to 0.0.0.0 before a new address when
/// needed (§5.1.1) and to its goal afterwards, passes through a free port when two ports swap, sets hold
/// mode None before One Shot. A step may write an item that `wanted` does not name only where the way
/// there needs it, and then a later step puts it where it belongs. Items already at their goal are not
/// written. What a wanted change drags along (§4.3.4) belongs to the goal unless `wanted` names it.
/// Pure; deterministic; at most a handful of steps more than there are items.
tl::expected<ApplyPlan, PlanFailure> planWrites(catalog::SensorModel model, const Values& current,
                                                const Values& wanted);

} // namespace lds::settings

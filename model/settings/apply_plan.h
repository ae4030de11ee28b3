#pragma once

#include "rules.h"

namespace lds::settings {

/// Ordered writes from `current` to `wanted`, each one accepted by the rules in turn (§4.4.1, §5.1.1).
struct ApplyPlan {
    QList<Write> steps;
};

/// Why there is no order of writes; the goal itself breaks a rule.
struct PlanFailure {
    QList<Refusal> refusals;
};

/// Plans the writes that take the sensor from `current` to `current` overlaid with `wanted`.
/// Widens the judgment window before moving it, sets the gateway to 0.0.0.0 before a new address when
/// needed (§5.1.1) and to its goal afterwards, passes through a free port when two ports swap, sets hold
/// mode None before One Shot. A step may write an item that `wanted` does not name only where the way
/// there needs it, and then a later step puts it where it belongs. Items already at their goal are not
/// written. Pure; deterministic; at most a handful of steps more than there are items.
tl::expected<ApplyPlan, PlanFailure> planWrites(catalog::SensorModel model, const Values& current,
                                                const Values& wanted);

} // namespace lds::settings

#pragma once

#include "rules.h"

#include <optional>

namespace lds::settings {

/// Internal to this folder. A write the search may use, and how little it likes to.
struct Move {
    Write write;
    int cost;
};

/// The cheapest sequence of moves from `start` to `goal` whose every write the rules accept in turn and
/// that changes something; nothing when there is none. `items` are the ones both states consist of.
/// The states are the combinations of the moves' values, a few hundred at most.
std::optional<QList<Write>> cheapestWay(catalog::SensorModel model, const QList<ItemId>& items,
                                        const Values& start, const Values& goal, const QList<Move>& moves);

} // namespace lds::settings

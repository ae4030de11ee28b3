#pragma once

#include "catalog.h"
#include "values.h"

#include <QList>
#include <tl/expected.hpp>

namespace lds::settings {

/// Why the sensor would refuse a write. ui/ turns code and items into a sentence.
enum class Rule {
    NotWritable,                ///< A status, or an item without an address.
    OutOfRange,                 ///< Outside the limits of the model (§5.2.4).
    NotAChoice,                 ///< A code the model does not have.
    HighNotAboveLow,            ///< §4.4.1: HIGH must be greater than LOW.
    WindowNotOverHysteresis,    ///< §4.4.1–4.4.3: HIGH − LOW must be more than twice the hysteresis.
    ToleranceNotOverHysteresis, ///< §4.4.5: judged when the tolerance is written; hysteresis itself is free.
    OneShotNeedsNormalHold,     ///< §4.3.4: One Shot only with hold mode None.
    PortReserved,               ///< §5.2.1: 44818 is taken.
    PortsEqual,                 ///< §5.2.1: tool and Modbus ports must differ.
    AddressFirstOctet,          ///< §5.2.1: 0, 127, 224–255.
    MaskNotContiguous,          ///< §5.2.1: ones, then zeros.
    AddressHostBits,            ///< §5.2.1: host part all zeros or all ones.
    AddressNetworkBits,         ///< §5.2.1: network part all zeros.
    GatewayFirstOctet,
    GatewayHostBits,
    GatewayOtherNetwork, ///< §5.2.1: gateway and address must be in one subnet.
    GroupIncomplete,     ///< Part of an address written without the other octets.
};

struct Refusal {
    Rule rule;
    QList<ItemId> items; ///< The items concerned, the written one first.
};

/// The rules as transitions: what the sensor's settings are after `write`, or why it would refuse.
/// One write may change other items (hold mode other than None turns One Shot into Hold, §4.3.4).
/// Written values are rounded down to the setting resolution first (§1.4).
/// Switches, procedures and commands are judged by their own limits only.
/// Items absent from `state` are unknown: rules that need them hold. A state the rules would not have
/// produced is accepted as a start; only what a write makes or leaves wrong *among the rules that write
/// touches* is refused, so that such a state can be repaired.
tl::expected<Values, Refusal> apply(catalog::SensorModel model, const Values& state, const Write& write);

/// Every rule the finished state would break; empty when it is one the sensor could hold. A tolerance that
/// is not over the hysteresis is one: raising the hysteresis leads there (§4.4.5). Whether a *change* of
/// the tolerance would be refused is goalProblems()'s to say (apply_plan.h). Only settings are looked at.
QList<Refusal> check(catalog::SensorModel model, const Values& state);

} // namespace lds::settings

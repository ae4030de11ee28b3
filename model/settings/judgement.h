#pragma once

#include "rules.h"

#include <initializer_list>
#include <optional>
#include <span>

namespace lds::settings {

/// Internal to this folder: the rules between items, judged for a finished state.

inline constexpr Value holdModeNone = 0;    ///< §5.2.4, 400115
inline constexpr Value triggerModeHold = 0; ///< §5.2.4, 400130
inline constexpr Value triggerModeOneShot = 1;

/// Whom a judgement is about. The sensor judges a write by the rules of the items it names; the rules
/// between two items it does not name stay silent.
class Subjects {
public:
    static Subjects everything() { return Subjects(); }
    explicit Subjects(const Write& write);

    bool isEverything() const { return !m_items.has_value(); }
    bool has(ItemId item) const;
    bool hasAny(std::span<const ItemId> items) const;
    bool hasAny(std::initializer_list<ItemId> items) const
    {
        return hasAny(std::span(items.begin(), items.size()));
    }
    /// A refusal with the items this is about first.
    Refusal refusal(Rule rule, QList<ItemId> items) const;

private:
    Subjects() = default;
    std::optional<QList<ItemId>> m_items;
};

/// The value, or nothing when it is not known.
std::optional<Value> known(const Values& state, ItemId item);

/// A value alone: writable, within the limits or one of the choices.
std::optional<Refusal> judgeValue(catalog::SensorModel model, const ItemValue& itemValue);

/// Every rule between items that `subjects` touch and `state` breaks. The tolerance is judged only where
/// it is named: the hysteresis may grow past it (§4.4.5).
QList<Refusal> judge(const Values& state, const Subjects& subjects);

/// The part of it about IP address, subnet mask and default gateway (§5.2.1 "IP setting conditions").
QList<Refusal> judgeNetwork(const Values& state, const Subjects& subjects);

/// What a write of these values changes by itself: a hold mode other than None turns One Shot into Hold
/// (§4.3.4).
void dragAlong(Values& state, const Write& write);

/// The octets of a group, the first one first; empty for WriteGroup::None.
std::span<const ItemId> octetsOf(catalog::WriteGroup group);

} // namespace lds::settings

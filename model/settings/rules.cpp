#include "rules.h"

#include "judgement.h"
#include "legal_values.h"
#include "value_text.h"

#include <algorithm>

namespace lds::settings {

namespace {

using catalog::Kind;
using catalog::SettingItem;

constexpr Value reservedPort = 44818; ///< EtherNet/IP's (§5.2.1, note 1)

Write roundedDown(catalog::SensorModel model, const Write& write)
{
    Write rounded = write;
    for (ItemValue& itemValue : rounded)
        itemValue.value = effectiveValue(catalog::hlG2(itemValue.item), model, itemValue.value);
    return rounded;
}

/// The octets of an address are judged together, so they have to come together.
std::optional<Refusal> judgeGroups(const Write& write)
{
    const Subjects written(write);
    for (const ItemValue& itemValue : write) {
        const std::span<const ItemId> octets = octetsOf(catalog::hlG2(itemValue.item).group);
        if (!std::all_of(octets.begin(), octets.end(), [&](ItemId octet) { return written.has(octet); }))
            return written.refusal(Rule::GroupIncomplete, {octets.begin(), octets.end()});
    }
    return std::nullopt;
}

/// §4.4.1–4.4.3
void judgeWindow(const Values& state, const Subjects& subjects, QList<Refusal>& refusals)
{
    const auto high = known(state, ItemId::HighSetValue);
    const auto low = known(state, ItemId::LowSetValue);
    const auto hysteresis = known(state, ItemId::Hysteresis);
    if (!subjects.hasAny({ItemId::HighSetValue, ItemId::LowSetValue, ItemId::Hysteresis}) || !high || !low)
        return;
    if (*high <= *low)
        refusals << subjects.refusal(Rule::HighNotAboveLow, {ItemId::HighSetValue, ItemId::LowSetValue});
    else if (hysteresis && qint64(*high) - *low <= 2 * qint64(*hysteresis))
        refusals << subjects.refusal(Rule::WindowNotOverHysteresis,
                                     {ItemId::HighSetValue, ItemId::LowSetValue, ItemId::Hysteresis});
}

/// §4.4.5
void judgeTolerance(const Values& state, const Subjects& subjects, QList<Refusal>& refusals)
{
    const auto tolerance = known(state, ItemId::Tolerance);
    const auto hysteresis = known(state, ItemId::Hysteresis);
    const bool isWritten = !subjects.isEverything() && subjects.has(ItemId::Tolerance);
    if (isWritten && tolerance && hysteresis && *tolerance <= *hysteresis)
        refusals << subjects.refusal(Rule::ToleranceNotOverHysteresis,
                                     {ItemId::Tolerance, ItemId::Hysteresis});
}

/// §4.3.4, §4.6.2
void judgeTrigger(const Values& state, const Subjects& subjects, QList<Refusal>& refusals)
{
    const auto holdMode = known(state, ItemId::HoldMode);
    if (subjects.hasAny({ItemId::TriggerMode, ItemId::HoldMode}) && holdMode && *holdMode != holdModeNone &&
        known(state, ItemId::TriggerMode) == triggerModeOneShot)
        refusals << subjects.refusal(Rule::OneShotNeedsNormalHold, {ItemId::TriggerMode, ItemId::HoldMode});
}

/// §5.2.1, notes 1 and 2
void judgePorts(const Values& state, const Subjects& subjects, QList<Refusal>& refusals)
{
    for (const ItemId port : {ItemId::PortModbus, ItemId::PortTool}) {
        if (subjects.has(port) && known(state, port) == reservedPort)
            refusals << subjects.refusal(Rule::PortReserved, {port});
    }
    const auto modbus = known(state, ItemId::PortModbus);
    const auto tool = known(state, ItemId::PortTool);
    if (subjects.hasAny({ItemId::PortModbus, ItemId::PortTool}) && modbus && tool && *modbus == *tool)
        refusals << subjects.refusal(Rule::PortsEqual, {ItemId::PortModbus, ItemId::PortTool});
}

} // namespace

Subjects::Subjects(const Write& write)
    : m_items(QList<ItemId>())
{
    for (const ItemValue& itemValue : write)
        m_items->append(itemValue.item);
}

bool Subjects::has(ItemId item) const { return !m_items || m_items->contains(item); }

bool Subjects::hasAny(std::span<const ItemId> items) const
{
    return std::any_of(items.begin(), items.end(), [this](ItemId item) { return has(item); });
}

Refusal Subjects::refusal(Rule rule, QList<ItemId> items) const
{
    std::stable_partition(items.begin(), items.end(), [this](ItemId item) { return has(item); });
    return {rule, items};
}

std::optional<Value> known(const Values& state, ItemId item)
{
    const auto found = state.constFind(item);
    return found == state.constEnd() ? std::nullopt : std::optional(*found);
}

std::optional<Refusal> judgeValue(catalog::SensorModel model, const ItemValue& itemValue)
{
    const SettingItem& item = catalog::hlG2(itemValue.item);
    if (!item.isWritable())
        return Refusal{Rule::NotWritable, {item.id}};
    if (!isLegal(item, model, itemValue.value))
        return Refusal{item.kind == Kind::Choice ? Rule::NotAChoice : Rule::OutOfRange, {item.id}};
    return std::nullopt;
}

QList<Refusal> judge(const Values& state, const Subjects& subjects)
{
    QList<Refusal> refusals;
    judgeWindow(state, subjects, refusals);
    judgeTolerance(state, subjects, refusals);
    judgeTrigger(state, subjects, refusals);
    judgePorts(state, subjects, refusals);
    return refusals + judgeNetwork(state, subjects);
}

void dragAlong(Values& state, const Write& write)
{
    const Subjects written(write);
    const auto holdMode = known(state, ItemId::HoldMode);
    if (written.has(ItemId::HoldMode) && !written.has(ItemId::TriggerMode) && *holdMode != holdModeNone &&
        known(state, ItemId::TriggerMode) == triggerModeOneShot)
        state[ItemId::TriggerMode] = triggerModeHold;
}

tl::expected<Values, Refusal> apply(catalog::SensorModel model, const Values& state, const Write& write)
{
    const Write rounded = roundedDown(model, write);
    for (const ItemValue& itemValue : rounded) {
        if (const std::optional<Refusal> refusal = judgeValue(model, itemValue))
            return tl::unexpected(*refusal);
    }
    if (const std::optional<Refusal> refusal = judgeGroups(rounded))
        return tl::unexpected(*refusal);

    Values next = state;
    for (const ItemValue& itemValue : rounded) {
        if (catalog::hlG2(itemValue.item).isReadable())
            next[itemValue.item] = itemValue.value;
    }
    dragAlong(next, rounded);
    if (const QList<Refusal> refusals = judge(next, Subjects(rounded)); !refusals.isEmpty())
        return tl::unexpected(refusals.first());
    return next;
}

QList<Refusal> check(catalog::SensorModel model, const Values& state)
{
    QList<Refusal> refusals;
    for (auto it = state.constBegin(); it != state.constEnd(); ++it) {
        const SettingItem& item = catalog::hlG2(it.key());
        if (item.role != catalog::Role::Setting || !item.isWritable())
            continue;
        if (const std::optional<Refusal> refusal = judgeValue(model, {item.id, it.value()}))
            refusals << *refusal;
    }
    return refusals + judge(state, Subjects::everything());
}

} // namespace lds::settings

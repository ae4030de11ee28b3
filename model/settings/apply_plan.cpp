#include "apply_plan.h"

#include "judgement.h"
#include "plan_search.h"
#include "value_text.h"

#include <algorithm>
#include <vector>

namespace lds::settings {

namespace {

using catalog::SensorModel;
using catalog::WriteGroup;

// What a step costs. Every step costs enough that the fewest win; among plans of one length those that
// write what the person wants, or turn the gateway off (§5.1.1), come before other detours.
constexpr int costOfGoal = 100;
constexpr int costOfUsualDetour = 101;
constexpr int costOfDetour = 102;

/// What is to change, and the state it leads to.
struct Goal {
    Values changes; ///< In wire units, rounded down to the resolution; only what differs from now.
    Values state;
    bool changesAny(std::span<const ItemId> items) const
    {
        return std::any_of(items.begin(), items.end(),
                           [this](ItemId item) { return changes.contains(item); });
    }
};

Write toWrite(const Values& values)
{
    Write write;
    for (auto it = values.constBegin(); it != values.constEnd(); ++it)
        write << ItemValue{it.key(), it.value()};
    return write;
}

Goal goalOf(SensorModel model, const Values& current, const Values& wanted)
{
    Goal goal{{}, current};
    for (auto it = wanted.constBegin(); it != wanted.constEnd(); ++it) {
        const Value effective = effectiveValue(catalog::hlG2(it.key()), model, it.value());
        const std::optional<Value> held = known(current, it.key());
        if (held == it.value() || held == effective)
            continue;
        goal.changes[it.key()] = effective;
        goal.state[it.key()] = effective;
    }
    Values named = goal.changes;
    if (wanted.contains(ItemId::TriggerMode)) // named, so nothing may drag it away
        named[ItemId::TriggerMode] = wanted[ItemId::TriggerMode];
    dragAlong(goal.state, toWrite(named));
    return goal;
}

QList<Refusal> judgeChangedValues(SensorModel model, const Goal& goal)
{
    QList<Refusal> refusals;
    for (const ItemValue& change : toWrite(goal.changes)) {
        const catalog::SettingItem& item = catalog::hlG2(change.item);
        const std::span<const ItemId> octets = octetsOf(item.group);
        if (item.role != catalog::Role::Setting)
            refusals << Refusal{Rule::NotWritable, {item.id}};
        else if (const std::optional<Refusal> refusal = judgeValue(model, change))
            refusals << *refusal;
        else if (!std::all_of(octets.begin(), octets.end(),
                              [&](ItemId octet) { return goal.state.contains(octet); }))
            refusals << Refusal{Rule::GroupIncomplete, {item.id}};
    }
    return refusals;
}

QList<Refusal> judgeChangedTolerance(const Values& current, const Goal& goal)
{
    const std::optional<Value> now = known(current, ItemId::Hysteresis);
    const std::optional<Value> then = known(goal.state, ItemId::Hysteresis);
    if (!goal.changes.contains(ItemId::Tolerance) || !then)
        return {};
    const Values smallest{{ItemId::Tolerance, goal.changes[ItemId::Tolerance]},
                          {ItemId::Hysteresis, std::min(now.value_or(*then), *then)}};
    return judge(smallest, Subjects({{ItemId::Tolerance, 0}}));
}

QList<Refusal> problemsOf(SensorModel model, const Values& current, const Goal& goal)
{
    Values withoutTolerance = goal.changes;
    withoutTolerance.remove(ItemId::Tolerance);
    return judgeChangedValues(model, goal) + judge(goal.state, Subjects(toWrite(withoutTolerance))) +
           judgeChangedTolerance(current, goal);
}

/// Items that rules tie together, with the writes that may lead through them.
class Cluster {
public:
    Cluster(SensorModel model, const Values& current, const Goal& goal)
        : m_model(model)
        , m_current(current)
        , m_goal(goal)
    {}

    /// One item, with values it may take on the way. A detour of an item that could not be put back, since
    /// what it holds is finer than the resolution or out of range, never leads to the goal.
    void add(ItemId item, const QList<Value>& detours = {})
    {
        QList<Write> writes;
        for (const Value detour : detours)
            writes << Write{{item, detour}};
        add(std::span(&item, 1), writes, costOfDetour);
    }

    /// The octets of an address, with addresses it may take on the way.
    void add(WriteGroup group, const QList<Write>& detours, int costOfDetours = costOfDetour)
    {
        add(octetsOf(group), detours, costOfDetours);
    }

    const QList<ItemId>& items() const { return m_items; }

    tl::expected<QList<Write>, PlanFailure> plan() const
    {
        const Values start = only(m_current);
        const Values end = only(m_goal.state);
        // Most plans need no detour, and without them there is little to search.
        std::optional<QList<Write>> way = cheapestWay(m_model, m_items, start, end, m_direct);
        if (!way)
            way = cheapestWay(m_model, m_items, start, end, m_direct + m_detours);
        if (!way)
            return tl::unexpected(PlanFailure{whatHoldsIt()});
        return *way;
    }

private:
    void add(std::span<const ItemId> items, const QList<Write>& detours, int costOfDetours)
    {
        m_items.append(QList<ItemId>(items.begin(), items.end()));
        Write home;
        for (const ItemId item : items) {
            const std::optional<Value> value = known(m_goal.state, item);
            if (!value)
                return;
            home << ItemValue{item, *value};
        }
        m_direct << Move{home, costOfGoal};
        for (const Write& detour : detours)
            m_detours << Move{detour, costOfDetours};
    }

    Values only(const Values& state) const
    {
        Values some;
        for (const ItemId item : m_items) {
            if (const std::optional<Value> value = known(state, item))
                some[item] = *value;
        }
        return some;
    }

    QList<Refusal> whatHoldsIt() const
    {
        QList<Refusal> refusals;
        for (const Move& move : m_direct) {
            const bool isWanted =
                std::any_of(move.write.begin(), move.write.end(),
                            [this](const ItemValue& each) { return m_goal.changes.contains(each.item); });
            if (!isWanted)
                continue;
            if (const auto next = apply(m_model, only(m_current), move.write); !next)
                refusals << next.error();
        }
        return refusals;
    }

    SensorModel m_model;
    const Values& m_current;
    const Goal& m_goal;
    QList<ItemId> m_items;
    QList<Move> m_direct;
    QList<Move> m_detours;
};

void addWindow(Cluster& cluster, SensorModel model)
{
    cluster.add(ItemId::HighSetValue, {catalog::hlG2(ItemId::HighSetValue).limitsFor(model).maximum});
    cluster.add(ItemId::LowSetValue, {catalog::hlG2(ItemId::LowSetValue).limitsFor(model).minimum});
    cluster.add(ItemId::Hysteresis, {catalog::hlG2(ItemId::Hysteresis).limitsFor(model).minimum});
    cluster.add(ItemId::Tolerance);
}

/// A port that nobody has or wants, for two that swap.
Value freePort(SensorModel model, const Values& current, const Goal& goal)
{
    const auto isTaken = [&](Value port) {
        for (const ItemId item : {ItemId::PortModbus, ItemId::PortTool}) {
            if (known(current, item) == port || known(goal.state, item) == port)
                return true;
        }
        return !judge({{ItemId::PortTool, port}}, Subjects::everything()).isEmpty();
    };
    Value port = catalog::hlG2(ItemId::PortTool).limitsFor(model).defaultValue;
    while (isTaken(port))
        ++port;
    return port;
}

void addPorts(Cluster& cluster, SensorModel model, const Values& current, const Goal& goal)
{
    const QList<Value> detour{freePort(model, current, goal)};
    cluster.add(ItemId::PortModbus, detour);
    cluster.add(ItemId::PortTool, detour);
}

Write addressWrite(WriteGroup group, quint32 address)
{
    Write write;
    int shift = 24;
    for (const ItemId octet : octetsOf(group)) {
        write << ItemValue{octet, Value((address >> shift) & 0xff)};
        shift -= 8;
    }
    return write;
}

Write factoryWrite(WriteGroup group, SensorModel model)
{
    Write write;
    for (const ItemId octet : octetsOf(group))
        write << ItemValue{octet, catalog::hlG2(octet).limitsFor(model).defaultValue};
    return write;
}

/// The longest mask the present address is valid in: the way out of a mask that no address is valid in.
QList<Write> maskThatSuits(const Values& current)
{
    Values state;
    for (const ItemId octet : octetsOf(WriteGroup::IpAddress)) {
        if (const std::optional<Value> value = known(current, octet))
            state[octet] = *value;
    }
    for (int hostBits = 2; hostBits < 32; ++hostBits) {
        const Write mask = addressWrite(WriteGroup::SubnetMask, ~0U << hostBits);
        for (const ItemValue& octet : mask)
            state[octet.item] = octet.value;
        if (judge(state, Subjects(mask)).isEmpty())
            return {mask};
    }
    return {};
}

/// With the gateway off, the factory address is valid in every mask that any address is valid in, so a way
/// through it exists wherever the old address does not fit the new mask nor the new address the old mask.
void addNetwork(Cluster& cluster, SensorModel model, const Values& current)
{
    cluster.add(WriteGroup::DefaultGateway, {addressWrite(WriteGroup::DefaultGateway, 0)}, costOfUsualDetour);
    cluster.add(WriteGroup::IpAddress, {factoryWrite(WriteGroup::IpAddress, model)});
    cluster.add(WriteGroup::SubnetMask, maskThatSuits(current));
}

std::vector<Cluster> clustersOf(SensorModel model, const Values& current, const Goal& goal)
{
    Cluster window(model, current, goal);
    addWindow(window, model);
    Cluster hold(model, current, goal);
    hold.add(ItemId::HoldMode);
    hold.add(ItemId::TriggerMode);
    Cluster ports(model, current, goal);
    addPorts(ports, model, current, goal);
    Cluster network(model, current, goal);
    addNetwork(network, model, current);
    return {window, hold, ports, network};
}

} // namespace

QList<Refusal> goalProblems(SensorModel model, const Values& current, const Values& wanted)
{
    return problemsOf(model, current, goalOf(model, current, wanted));
}

tl::expected<ApplyPlan, PlanFailure> planWrites(SensorModel model, const Values& current,
                                                const Values& wanted)
{
    const Goal goal = goalOf(model, current, wanted);
    if (const QList<Refusal> refusals = problemsOf(model, current, goal); !refusals.isEmpty())
        return tl::unexpected(PlanFailure{refusals});

    ApplyPlan plan;
    Values single = goal.changes;
    for (const Cluster& cluster : clustersOf(model, current, goal)) {
        if (!goal.changesAny(cluster.items()))
            continue;
        const auto steps = cluster.plan();
        if (!steps)
            return tl::unexpected(steps.error());
        plan.steps += *steps;
        for (const ItemId item : cluster.items())
            single.remove(item);
    }
    for (const ItemValue& change : toWrite(single))
        plan.steps << Write{change};
    return plan;
}

} // namespace lds::settings

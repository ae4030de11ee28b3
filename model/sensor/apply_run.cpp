#include "apply_run.h"

#include "catalog.h"
#include "command_effects.h"

#include <algorithm>

namespace lds::sensor {

using ports::Status;

namespace {

QList<ItemId> itemsOf(const settings::Write& write)
{
    QList<ItemId> items;
    for (const settings::ItemValue& each : write)
        items.append(each.item);
    return items;
}

QList<ItemId> allSettings()
{
    QList<ItemId> items{ItemId::BankSwitching};
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (item.role == catalog::Role::Setting && item.isReadable())
            items.append(item.id);
    }
    return items;
}

settings::Values over(settings::Values below, const settings::Values& above)
{
    below.insert(above);
    return below;
}

/// The item, with those that are written in one message with it.
settings::Values sameGroup(const settings::Values& values, ItemId item)
{
    const catalog::WriteGroup group = catalog::hlG2(item).group;
    settings::Values some{{item, values.value(item)}};
    for (auto it = values.constBegin(); it != values.constEnd(); ++it) {
        if (group != catalog::WriteGroup::None && catalog::hlG2(it.key()).group == group)
            some.insert(it.key(), it.value());
    }
    return some;
}

} // namespace

ApplyRun::ApplyRun(RunHost& host, const PendingEdits::Edits& edits, Finished finished)
    : m_host(host)
    , m_read(host)
    , m_finished(std::move(finished))
{
    for (auto it = edits.constBegin(); it != edits.constEnd(); ++it)
        m_goals.insert(it.key(), it->wanted);
}

void ApplyRun::begin()
{
    m_start = m_host.heldNow();
    leaveWithdrawn();
    const settings::Values wanted = openGoals();
    const auto plan = settings::planWrites(m_host.sensorModel(), m_start, wanted);
    if (!plan) {
        m_report.planFailure = plan.error();
        return finish();
    }
    takePlan(wanted);
    next();
}

void ApplyRun::cancel() { m_cancelled = m_mustPlan = true; }

void ApplyRun::connectionGone()
{
    if (!m_finished)
        return;
    m_report.connectionLost = true;
    if (m_underWay)
        failStep(m_report.unknown);
    finish();
}

/// Goes on with the plan, or makes a new one where something has come up since.
void ApplyRun::next()
{
    if (leaveWithdrawn())
        m_mustPlan = true;
    if (std::exchange(m_mustPlan, false))
        replan();
    if (m_steps.isEmpty())
        return finish();

    m_step = {};
    m_step.write = m_steps.takeFirst();
    for (const settings::ItemValue& each : std::as_const(m_step.write)) {
        if (!m_start.contains(each.item))
            continue;
        m_step.before.insert(each.item, m_start.value(each.item));
        if (!isFinal(m_step.write))
            m_onTheWay.insert(each.item);
    }
    m_changing = changing(m_step.write);
    m_underWay = true;
    ports::Request request;
    request.kind = ports::RequestKind::Write;
    request.urgency = ports::Urgency::Person;
    request.write = m_step.write;
    m_host.ask(request, &m_context, [this](const ports::Outcome& outcome) { written(outcome); });
}

void ApplyRun::replan()
{
    m_steps.clear();
    const settings::Values goals = m_cancelled ? settings::Values{} : openGoals();
    const settings::Values back = valuesToPutBack();
    if (!takePlan(over(back, goals)))
        takePlan(largestPart(back, largestPart(goals, {})));
}

bool ApplyRun::takePlan(const settings::Values& wanted)
{
    const auto plan = settings::planWrites(m_host.sensorModel(), m_host.heldNow(), wanted);
    if (!isUsable(plan))
        return false;
    m_steps = plan->steps;
    m_host.runProgressed(m_done, m_done + int(m_steps.size()));
    return true;
}

/// Whether a write leaves its items where they are to stay. A gateway of 0.0.0.0 on the way to another
/// network does not, even where some of its octets are to be 0 in the end.
bool ApplyRun::isFinal(const settings::Write& write) const
{
    return std::all_of(write.begin(), write.end(), [this](const settings::ItemValue& each) {
        return each.value == m_goals.value(each.item, m_start.value(each.item));
    });
}

bool ApplyRun::isUsable(const tl::expected<settings::ApplyPlan, settings::PlanFailure>& plan) const
{
    return plan && std::none_of(plan->steps.begin(), plan->steps.end(), [this](const settings::Write& step) {
               return std::any_of(step.begin(), step.end(), [this](const settings::ItemValue& each) {
                   return m_failed.contains(each.item);
               });
           });
}

/// `part` and as much of `wanted` as there is an order of writes for. Each item is tried with those that
/// fit so far, again and again until no more fit: one may only become possible by another.
settings::Values ApplyRun::largestPart(const settings::Values& wanted, settings::Values part) const
{
    bool grown = true;
    while (grown) {
        grown = false;
        for (auto it = wanted.constBegin(); it != wanted.constEnd(); ++it) {
            if (part.contains(it.key()))
                continue;
            const settings::Values tried = over(sameGroup(wanted, it.key()), part);
            if (!isUsable(settings::planWrites(m_host.sensorModel(), m_host.heldNow(), tried)))
                continue;
            part = tried;
            grown = true;
        }
    }
    return part;
}

/// Edits taken back or changed by the person meanwhile, or come into conflict, are no goals any more.
bool ApplyRun::leaveWithdrawn()
{
    bool changed = false;
    const settings::Values goals = openGoals();
    for (auto it = goals.constBegin(); it != goals.constEnd(); ++it) {
        const std::optional<PendingEdit> edit = m_host.pendingEdit(it.key());
        if (edit && edit->wanted == it.value() && !edit->conflict)
            continue;
        if (edit && edit->conflict)
            m_report.inConflict.append(it.key());
        m_goals.remove(it.key());
        changed = true;
    }
    return changed;
}

/// What a write changes by the rules, itself included (§4.3.4), and the trigger input, which a change of
/// the trigger mode clears (§4.6.2).
QList<ItemId> ApplyRun::changing(const settings::Write& write) const
{
    QList<ItemId> items = itemsOf(write);
    const settings::Values& held = m_host.heldNow();
    if (const auto after = settings::apply(m_host.sensorModel(), held, write)) {
        for (auto it = after->constBegin(); it != after->constEnd(); ++it) {
            if (held.value(it.key()) != it.value() && !items.contains(it.key()))
                items.append(it.key());
        }
    }
    if (items.contains(ItemId::HoldMode) && !items.contains(ItemId::TriggerMode))
        items.append(ItemId::TriggerMode);
    if (items.contains(ItemId::TriggerMode))
        items += {ItemId::TriggerInputCommunication, ItemId::HoldState};
    return items;
}

void ApplyRun::written(const ports::Outcome& outcome)
{
    m_step.status = outcome.status;
    m_step.failure = outcome.failure;
    if (isConnectionGone(outcome))
        return connectionGone();
    if (outcome.status == Status::Refused)
        return refused();
    if (outcome.status == Status::Done)
        m_host.setSaved(Saved::NotSaved);
    else if (m_host.savedNow() == Saved::Saved)
        m_host.setSaved(Saved::Unknown);
    readBack();
}

void ApplyRun::readBack()
{
    // The bank comes along: an edit made for one bank must not run on into another.
    m_read.start(
        m_changing + QList{ItemId::BankSwitching}, m_changing, {},
        [this](PatientRead::End end, const settings::Values& read, const HeldValues::Changes& changes) {
            if (end == PatientRead::End::ConnectionGone)
                connectionGone();
            else
                compare(read, changes);
        });
}

void ApplyRun::compare(const settings::Values& read, const HeldValues::Changes& changes)
{
    bool known = true;
    bool asWanted = true;
    for (const settings::ItemValue& each : std::as_const(m_step.write)) {
        const auto found = read.constFind(each.item);
        if (found == read.constEnd()) {
            known = false;
            continue;
        }
        m_step.readBack.insert(each.item, *found);
        asWanted = asWanted && *found == each.value;
    }
    if (known && asWanted)
        reached(changes);
    else if (known && m_step.status == Status::Done)
        failStep(m_report.different);
    else
        failStep(m_report.unknown);
    stepEnded();
}

void ApplyRun::reached(const HeldValues::Changes& changes)
{
    if (m_step.status == Status::Unknown) { // the answer was lost, the write was not
        m_step.status = Status::Done;
        m_host.setSaved(Saved::NotSaved);
    }
    if (isFinal(m_step.write)) {
        bool anyGoal = false;
        for (const settings::ItemValue& each : std::as_const(m_step.write)) {
            if (!m_goals.contains(each.item))
                continue;
            anyGoal = true;
            m_reached.insert(each.item);
            m_host.editReached(each.item, each.value);
        }
        if (anyGoal)
            m_report.written.append(m_step);
    }
    const QList<ItemId> asked = itemsOf(m_step.write);
    for (const ExternalChange& change : changes.moved) {
        if (!asked.contains(change.item) && m_changing.contains(change.item) &&
            command_effects::isStored(change.item) && !m_report.changedByItself.contains(change.item))
            m_report.changedByItself.append(change.item);
    }
}

/// A refusal that the rules did not foresee: the sensor is not where we thought. Everything is read
/// before a new order is planned. A sensor that refuses reading as well is in its menu (§5.2.2): the rest
/// would be refused, too.
void ApplyRun::refused()
{
    m_read.start(
        allSettings(), m_changing, {},
        [this](PatientRead::End end, const settings::Values& read, const HeldValues::Changes& changes) {
            for (const settings::ItemValue& each : std::as_const(m_step.write)) {
                if (read.contains(each.item))
                    m_step.readBack.insert(each.item, read.value(each.item));
                if (changes.contains(each.item)) // a write that failed halfway (§5.2.3)
                    m_host.setSaved(Saved::NotSaved);
            }
            failStep(m_report.refused);
            if (end == PatientRead::End::ConnectionGone)
                return connectionGone();
            if (end != PatientRead::End::Read)
                return finish();
            stepEnded();
        });
}

void ApplyRun::failStep(QList<WriteResult>& list)
{
    m_underWay = false;
    m_mustPlan = true;
    for (const settings::ItemValue& each : std::as_const(m_step.write))
        m_failed.insert(each.item);
    list.append(m_step);
}

void ApplyRun::stepEnded()
{
    m_underWay = false;
    ++m_done;
    m_host.runProgressed(m_done, m_done + int(m_steps.size()));
    next();
}

void ApplyRun::finish()
{
    if (!m_finished)
        return;
    m_report.notTried = openGoals().keys();
    m_report.cancelled = m_cancelled && !m_report.notTried.isEmpty();
    std::exchange(m_finished, {})(m_report);
}

settings::Values ApplyRun::openGoals() const
{
    settings::Values open;
    for (auto it = m_goals.constBegin(); it != m_goals.constEnd(); ++it) {
        if (!m_reached.contains(it.key()) && !m_failed.contains(it.key()))
            open.insert(it.key(), it.value());
    }
    return open;
}

/// What was changed only for the way there, with the value it goes back to.
settings::Values ApplyRun::valuesToPutBack() const
{
    settings::Values back;
    for (const ItemId item : m_onTheWay) {
        if (!m_failed.contains(item))
            back.insert(item, m_reached.contains(item) ? m_goals.value(item) : m_start.value(item));
    }
    return back;
}

} // namespace lds::sensor

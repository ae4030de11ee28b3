#include "pending_edits.h"

#include "catalog.h"

#include <algorithm>
#include <QSet>

namespace lds::sensor {

namespace {

constexpr int longestHistory = 500; ///< Steps; far beyond what a person takes back.

/// The item and those that make one thing with it: the octets of an address.
QList<ItemId> together(ItemId item)
{
    const catalog::WriteGroup group = catalog::hlG2(item).group;
    if (group == catalog::WriteGroup::None)
        return {item};
    QList<ItemId> items;
    for (const catalog::SettingItem& each : catalog::Catalog::hlG2().items()) {
        if (each.group == group)
            items.append(each.id);
    }
    return items;
}

std::optional<Value> bankFor(ItemId item, const settings::Values& held)
{
    if (catalog::hlG2(item).scope != catalog::Scope::Bank || !held.contains(ItemId::BankSwitching))
        return std::nullopt;
    return held.value(ItemId::BankSwitching);
}

bool otherBankRuns(ItemId item, const PendingEdit& edit, const settings::Values& held)
{
    const std::optional<Value> running = bankFor(item, held);
    return edit.bank && running && *edit.bank != *running;
}

void confirmEdit(ItemId item, PendingEdit& edit, const settings::Values& held)
{
    edit.baseKnown = held.contains(item);
    edit.base = held.value(item);
    edit.bank = bankFor(item, held);
    edit.conflict = false;
}

} // namespace

std::optional<PendingEdit> PendingEdits::find(ItemId item) const
{
    const auto found = m_edits.constFind(item);
    return found == m_edits.constEnd() ? std::nullopt : std::optional(*found);
}

int PendingEdits::count() const
{
    int count = 0;
    QSet<catalog::WriteGroup> groups;
    for (auto it = m_edits.constBegin(); it != m_edits.constEnd(); ++it) {
        const catalog::WriteGroup group = catalog::hlG2(it.key()).group;
        if (group == catalog::WriteGroup::None)
            ++count;
        else
            groups.insert(group);
    }
    return count + int(groups.size());
}

void PendingEdits::set(const QList<settings::ItemValue>& wanted, const settings::Values& held)
{
    Edits next = m_edits;
    for (const settings::ItemValue& each : wanted) {
        for (const ItemId item : together(each.item)) {
            if (item != each.item && !next.contains(item) && !held.contains(item))
                continue;
            PendingEdit edit;
            if (item == each.item)
                edit.wanted = each.value;
            else
                edit.wanted = next.contains(item) ? next.value(item).wanted : held.value(item);
            confirmEdit(item, edit, held);
            next.insert(item, edit);
        }
    }
    replace(settled(std::move(next), held));
}

void PendingEdits::remove(const QList<ItemId>& items)
{
    Edits next = m_edits;
    for (const ItemId item : items) {
        for (const ItemId each : together(item))
            next.remove(each);
    }
    replace(std::move(next));
}

void PendingEdits::clear() { replace({}); }

void PendingEdits::undo(const settings::Values& held)
{
    if (m_undo.isEmpty())
        return;
    m_redo.append(m_edits);
    m_edits = settled(m_undo.takeLast(), held);
    forgetEmptySteps(held);
}

void PendingEdits::redo(const settings::Values& held)
{
    if (m_redo.isEmpty())
        return;
    m_undo.append(m_edits);
    m_edits = settled(m_redo.takeLast(), held);
    forgetEmptySteps(held);
}

void PendingEdits::rebase(const settings::Values& held)
{
    m_edits = settled(std::move(m_edits), held);
    forgetEmptySteps(held);
}

void PendingEdits::follow(const QList<ItemId>& items, const settings::Values& held)
{
    const auto followIn = [&](Edits& edits) {
        for (const ItemId item : items) {
            const auto found = edits.find(item);
            if (found != edits.end() && !otherBankRuns(item, *found, held))
                confirmEdit(item, *found, held);
        }
    };
    followIn(m_edits);
    std::for_each(m_undo.begin(), m_undo.end(), followIn);
    std::for_each(m_redo.begin(), m_redo.end(), followIn);
    rebase(held);
}

void PendingEdits::applied(ItemId item)
{
    m_edits.remove(item);
    for (Edits& step : m_undo)
        step.remove(item);
    for (Edits& step : m_redo)
        step.remove(item);
    forgetEmptySteps({});
}

void PendingEdits::confirm(ItemId item, const settings::Values& held)
{
    for (const ItemId each : together(item)) {
        const auto found = m_edits.find(each);
        if (found != m_edits.end())
            confirmEdit(each, *found, held);
    }
    rebase(held);
}

settings::Values PendingEdits::wantedValues() const
{
    settings::Values wanted;
    for (auto it = m_edits.constBegin(); it != m_edits.constEnd(); ++it)
        wanted.insert(it.key(), it->wanted);
    return wanted;
}

void PendingEdits::replace(Edits edits)
{
    if (edits == m_edits)
        return;
    m_undo.append(std::exchange(m_edits, std::move(edits)));
    m_redo.clear();
    if (m_undo.size() > longestHistory)
        m_undo.removeFirst();
    forgetEmptySteps({});
}

/// Conflicts as they are now, and without the edits that have come true. The octets of an address are in
/// conflict together and come true together: a gateway that is 0.0.0.0 for a moment on the way to another
/// network has not reached 10.0.0.1 by three of its octets.
PendingEdits::Edits PendingEdits::settled(Edits edits, const settings::Values& held)
{
    QMap<catalog::WriteGroup, bool> conflicts;
    QMap<catalog::WriteGroup, bool> differs;
    for (auto it = edits.begin(); it != edits.end(); ++it) {
        const catalog::WriteGroup group = catalog::hlG2(it.key()).group;
        if (!held.contains(it.key())) {
            differs[group] = true;
            continue;
        }
        if (!it->baseKnown)
            confirmEdit(it.key(), *it, held);
        it->conflict = otherBankRuns(it.key(), *it, held) || it->base != held.value(it.key());
        conflicts[group] = conflicts.value(group) || it->conflict;
        differs[group] = differs.value(group) || it->wanted != held.value(it.key());
    }
    for (auto it = edits.begin(); it != edits.end();) {
        const catalog::WriteGroup group = catalog::hlG2(it.key()).group;
        const bool grouped = group != catalog::WriteGroup::None;
        if (grouped)
            it->conflict = conflicts.value(group);
        const bool asWanted = held.contains(it.key()) && held.value(it.key()) == it->wanted;
        const bool cameTrue =
            asWanted && !otherBankRuns(it.key(), *it, held) && !(grouped && differs.value(group));
        if (cameTrue)
            it = edits.erase(it);
        else
            ++it;
    }
    return edits;
}

bool PendingEdits::wantSame(const Edits& left, const Edits& right)
{
    return left.keys() == right.keys() &&
           std::equal(left.begin(), left.end(), right.begin(),
                      [](const PendingEdit& a, const PendingEdit& b) { return a.wanted == b.wanted; });
}

/// A step that would change nothing is none: the button would seem dead.
void PendingEdits::forgetEmptySteps(const settings::Values& held)
{
    while (!m_undo.isEmpty() && wantSame(settled(m_undo.last(), held), m_edits))
        m_undo.removeLast();
    while (!m_redo.isEmpty() && wantSame(settled(m_redo.last(), held), m_edits))
        m_redo.removeLast();
}

} // namespace lds::sensor

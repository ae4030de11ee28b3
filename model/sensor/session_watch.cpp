#include "session_core.h"

#include "catalog.h"
#include "command_effects.h"

namespace lds::sensor {

/// One step of the slow walk. A step that finds the last one still on its way is left out.
void SensorSession::Private::walk()
{
    startTimer(walkTimer, timing.walkIntervalMs, &Private::walk);
    if (connection != Connection::Ready || readingUnderWay || applying || running)
        return;
    if (bankIsOther)
        readAgain();
    else
        read(settingsWalk.next(), ports::Urgency::Background);
}

void SensorSession::Private::read(const QList<ItemId>& items, ports::Urgency urgency)
{
    if (items.isEmpty())
        return;
    readingUnderWay = true;
    ports::Request request;
    request.kind = ports::RequestKind::Read;
    request.urgency = urgency;
    request.items = items;
    ask(request, client, [this, ticket = readingTicket](const ports::Outcome& outcome) {
        if (ticket == readingTicket)
            readingEnded(outcome);
    });
}

/// Reads everything once more, after what is under way.
void SensorSession::Private::readAgain()
{
    readAllWanted = true;
    if (connection != Connection::Ready || readingUnderWay || applying || running)
        return;
    readAllWanted = false;
    readingIsFull = true;
    read(readableItems(false), ports::Urgency::Person);
}

void SensorSession::Private::readingEnded(const ports::Outcome& outcome)
{
    readingUnderWay = false;
    const bool full = std::exchange(readingIsFull, false);
    if (outcome.status == ports::Status::Done) {
        // After somebody has switched the bank what differs is the other bank's, not changed by anybody.
        const bool catchesUp = full && std::exchange(bankIsOther, false);
        learn(outcome.values, outcome.finishedNs,
              catchesUp ? command_effects::bankScoped() : QList<ItemId>{});
        readAllWanted = readAllWanted || bankIsOther;
    }
    if (readAllWanted)
        readAgain();
}

/// A reading on its way while something is written could be compared with the wrong state: it counts no more.
void SensorSession::Private::voidReadings()
{
    readAllWanted = readAllWanted || readingIsFull;
    ++readingTicket;
    readingUnderWay = false;
    readingIsFull = false;
}

QList<ItemId> SensorSession::Private::readableItems(bool walkOnly) const
{
    QList<ItemId> items;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        const bool stored = item.role == catalog::Role::Setting || command_effects::isStored(item.id);
        if (item.isReadable() && reachable.contains(item.id) && (stored || !walkOnly))
            items.append(item.id);
    }
    return items;
}

HeldValues::Changes SensorSession::Private::learn(const settings::Values& values, qint64 atNs,
                                                  const QList<ItemId>& ownOfRun)
{
    const QList<ItemId> own = ownOfRun + writtenByProcedure;
    writtenByProcedure.removeIf([&values](ItemId item) { return values.contains(item); });
    const HeldValues::Changes changes = held.update(values, atNs > 0 ? atNs : scheduler.nowNs());
    if (changes.items.isEmpty())
        return changes;
    announcer.addHeld(changes.items);
    updateFit();
    bool bankSwitched = false;
    for (const ExternalChange& change : changes.moved)
        bankSwitched = bankSwitched || (change.item == ItemId::BankSwitching && !own.contains(change.item));
    if (bankSwitched)
        bankIsOther = true;
    noteExternal(changes, own, bankSwitched);
    settlePending(own);
    return changes;
}

void SensorSession::Private::noteExternal(const HeldValues::Changes& changes, const QList<ItemId>& own,
                                          bool bankSwitched)
{
    QList<ExternalChange> external;
    for (const ExternalChange& change : changes.moved) {
        const bool otherBanks = bankSwitched && catalog::hlG2(change.item).scope == catalog::Scope::Bank;
        if (!own.contains(change.item) && !otherBanks && command_effects::isStored(change.item))
            external.append(change);
    }
    if (external.isEmpty())
        return;
    setSaved(Saved::Unknown);
    announcer.add([session = q, external] { Q_EMIT session->externallyChanged(external); });
}

/// Edits whose base has moved by somebody else's hand come into conflict; by ours they follow.
void SensorSession::Private::settlePending(const QList<ItemId>& own)
{
    const PendingEdits::Edits before = pending.edits();
    const bool couldUndo = pending.canUndo();
    const bool couldRedo = pending.canRedo();
    pending.follow(own, held.values());
    if (pending.edits() != before || pending.canUndo() != couldUndo || pending.canRedo() != couldRedo)
        announcer.add(Announcer::News::Pending);

    QList<ItemId> conflicts;
    for (auto it = pending.edits().constBegin(); it != pending.edits().constEnd(); ++it) {
        const auto found = before.constFind(it.key());
        if (it->conflict && !(found != before.constEnd() && found->conflict))
            conflicts.append(it.key());
    }
    if (!conflicts.isEmpty())
        announcer.add([session = q, conflicts] { Q_EMIT session->conflictsFound(conflicts); });
}

void SensorSession::Private::updateFit()
{
    const catalog::ModelMask now = settings::modelsThatFit(held.values());
    if (std::exchange(fit, now) != now)
        announcer.add(Announcer::News::Identity);
}

} // namespace lds::sensor

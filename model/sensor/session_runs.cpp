#include "session_core.h"

#include "catalog.h"

#include <algorithm>

namespace lds::sensor {

bool SensorSession::Private::canWrite() const
{
    return connection == Connection::Ready && !url.viewOnly && !notReady && !desk.isTaken() && !applying &&
           !running && !bankIsOther;
}

bool SensorSession::Private::canRun(ItemId id, Value value) const
{
    const catalog::SettingItem& item = catalog::hlG2(id);
    if (item.role == catalog::Role::Setting || item.role == catalog::Role::Status || !item.isWritable())
        return false;
    if (!reachable.contains(id) || !canWrite())
        return false;
    if (item.choices.empty()) {
        const catalog::Limits& limits = item.limitsFor(sensorModel());
        return value >= limits.minimum && value <= limits.maximum;
    }
    return std::any_of(item.choices.begin(), item.choices.end(), [&](const catalog::Choice& choice) {
        return choice.code == value && (choice.models & catalog::maskOf(sensorModel()));
    });
}

bool SensorSession::Private::apply()
{
    if (!canWrite())
        return false;
    lease = desk.acquire();
    voidReadings();
    applying = std::make_unique<ApplyRun>(*this, pending.edits(),
                                          [this](const ApplyReport& result) { applyEnded(result); });
    // Not inside the call: who asked hears the end only after knowing that it began.
    QMetaObject::invokeMethod(
        applying->context(),
        [this] {
            Turn turn(*this);
            applying->begin();
        },
        Qt::QueuedConnection);
    return true;
}

bool SensorSession::Private::run(ItemId item, Value value)
{
    if (!canRun(item, value))
        return false;
    lease = desk.acquire();
    voidReadings();
    running = std::make_unique<CommandRun>(*this, item, value, timing.saveTimeoutMs,
                                           [this](const CommandReport& result) { commandEnded(result); });
    running->begin();
    return true;
}

void SensorSession::Private::applyEnded(const ApplyReport& result)
{
    retiredApplies.push_back(std::move(applying));
    announcer.add([session = q, result] { Q_EMIT session->applyFinished(result); });
    runEnded();
}

void SensorSession::Private::commandEnded(const CommandReport& result)
{
    retiredCommands.push_back(std::move(running));
    announcer.add([session = q, result] { Q_EMIT session->commandFinished(result); });
    runEnded();
}

void SensorSession::Private::runEnded()
{
    lease.release();
    if (readAllWanted || bankIsOther)
        readAgain();
}

/// The connection is gone: whatever is under way ends now, and says so.
void SensorSession::Private::endRuns()
{
    if (applying)
        applying->connectionGone();
    if (running)
        running->connectionGone();
}

void SensorSession::Private::editReached(ItemId item, Value value)
{
    const std::optional<PendingEdit> edit = pending.find(item);
    if (edit && edit->wanted != value)
        return; // the person wants something else by now
    pending.applied(item);
    announcer.add(Announcer::News::Pending);
}

void SensorSession::Private::runProgressed(int done, int total)
{
    announcer.add([session = q, done, total] { Q_EMIT session->applyProgress(done, total); });
}

} // namespace lds::sensor

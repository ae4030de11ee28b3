#include "session_core.h"

#include "catalog.h"
#include "command_effects.h"

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

bool SensorSession::Private::askFor(const Lease& holder, const ports::Request& request, QObject* context,
                                    Answer answer)
{
    const bool isWrite = request.kind == ports::RequestKind::Write;
    if (!desk.hasLent(holder) || connection != Connection::Ready || (isWrite && url.viewOnly))
        return false;
    if (isWrite)
        voidReadings();
    const quint64 number = ++lastAsked;
    asked.insert(number, {request, context, std::move(answer)});
    ask(request, client, [this, number](const ports::Outcome& outcome) { askEnded(number, outcome); });
    return true;
}

void SensorSession::Private::askEnded(quint64 number, const ports::Outcome& outcome)
{
    const Asked ended = asked.take(number);
    if (outcome.kind == ports::RequestKind::Read && outcome.status == ports::Status::Done)
        learn(outcome.values, outcome.finishedNs, {});
    if (outcome.kind == ports::RequestKind::Write && outcome.status != ports::Status::Refused) {
        for (const settings::ItemValue& written : ended.request.write) {
            writtenByProcedure.append(written.item);
            const Saved after = command_effects::savedAfter(saved, written.item);
            setSaved(outcome.status == ports::Status::Done || after == saved ? after : Saved::Unknown);
        }
    }
    announcer.add([ended, outcome] {
        if (ended.context)
            ended.answer(outcome);
    });
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
    while (!asked.isEmpty()) {
        ports::Outcome outcome;
        outcome.kind = asked.first().request.kind;
        outcome.failure.code = ports::FailureCode::ConnectionLost;
        askEnded(asked.firstKey(), outcome);
    }
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

#include "command_run.h"

#include "command_effects.h"

namespace lds::sensor {

using ports::Status;

CommandRun::CommandRun(RunHost& host, ItemId item, Value value, int memoryTimeoutMs, Finished finished)
    : m_host(host)
    , m_read(host)
    , m_memoryTimeoutMs(memoryTimeoutMs)
    , m_finished(std::move(finished))
{
    m_report.item = item;
    m_report.value = value;
}

void CommandRun::begin()
{
    ports::Request request;
    request.kind = ports::RequestKind::Write;
    request.urgency = ports::Urgency::Person;
    request.write = {{m_report.item, m_report.value}};
    if (command_effects::writesMemory(m_report.item))
        request.timeoutMs = m_memoryTimeoutMs;
    m_host.ask(request, &m_context, [this](const ports::Outcome& outcome) { answered(outcome); });
}

void CommandRun::connectionGone()
{
    if (!m_finished)
        return;
    if (m_report.status != Status::Done) {
        m_report.status = Status::Unknown;
        m_report.failure.code = ports::FailureCode::ConnectionLost;
    }
    finish();
}

void CommandRun::answered(const ports::Outcome& outcome)
{
    m_report.status = outcome.status;
    m_report.failure = outcome.failure;
    if (isConnectionGone(outcome))
        return connectionGone();
    if (outcome.status == Status::Refused)
        return finish();
    readBack(outcome.status == Status::Done);
}

void CommandRun::readBack(bool carriedOut)
{
    const QList<ItemId> items = command_effects::readBack(m_report.item, m_report.value, m_host.heldNow());
    PatientRead::Patience patience;
    if (command_effects::writesMemory(m_report.item)) {
        patience.pauseMs = 500;
        patience.tries = std::max(3, m_memoryTimeoutMs / patience.pauseMs);
    }
    m_read.start(
        items, items, patience,
        [this, carriedOut](PatientRead::End end, const settings::Values& read, const HeldValues::Changes&) {
            if (end == PatientRead::End::ConnectionGone)
                connectionGone();
            else
                readBackEnded(carriedOut, read);
        });
}

void CommandRun::readBackEnded(bool carriedOut, const settings::Values& read)
{
    const auto found = read.constFind(m_report.item);
    if (!carriedOut && found != read.constEnd() && *found == m_report.value)
        m_report.status = Status::Done;
    finish();
}

void CommandRun::noteSaved()
{
    const Saved before = m_host.savedNow();
    const Saved after = command_effects::savedAfter(before, m_report.item);
    if (m_report.status == Status::Refused || after == before)
        return;
    if (m_report.status == Status::Done)
        m_host.setSaved(after);
    else if (before == Saved::Saved || after != Saved::NotSaved) // a loss of NotSaved would be a guess
        m_host.setSaved(Saved::Unknown);
}

void CommandRun::finish()
{
    if (!m_finished)
        return;
    noteSaved();
    std::exchange(m_finished, {})(m_report);
}

} // namespace lds::sensor

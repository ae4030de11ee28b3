#include "communication_change.h"

namespace lds::procedures {

using ports::FailureCode;
using ports::Status;
using sensor::Connection;
using sensor::SensorSession;

namespace {

constexpr int triesToCompare = 3;

bool isConnectionGone(const ports::Outcome& outcome)
{
    return outcome.status == Status::Unknown && (outcome.failure.code == FailureCode::ConnectionLost ||
                                                 outcome.failure.code == FailureCode::NotConnected);
}

ports::Request writeOf(ItemId item, catalog::Value value)
{
    ports::Request request;
    request.kind = ports::RequestKind::Write;
    request.urgency = ports::Urgency::Procedure;
    request.write = {{item, value}};
    return request;
}

} // namespace

// --- Is the address free?

void CommunicationChange::check()
{
    enter(State::Checking);
    ports::ConnectionUrl asked = m_former;
    asked.unit = m_new.unit;
    asked.viewOnly = true;
    m_probe = new sensor::LinkClient(m_links.create(asked), this);
    connect(m_probe, &sensor::LinkClient::reported, m_run.get(),
            [this](const ports::LinkReport& report) { checked(report); });
    m_probe->open();
}

void CommunicationChange::checked(const ports::LinkReport& report)
{
    if (m_state != State::Checking || !m_probe)
        return;
    const bool isOpen = report.state == ports::LinkState::Open;
    if (!isOpen && report.state != ports::LinkState::Failed)
        return;
    m_probe->shutDown();
    m_probe.clear();
    if (isOpen || report.failure == ports::OpenFailure::NotASensor ||
        report.failure == ports::OpenFailure::NotReady)
        return fail(ChangeProblem::AddressAnswers);
    if (report.failure != ports::OpenFailure::NoAnswer)
        return fail(ChangeProblem::PortFailed, {{}, {}, {}, report});
    write();
}

// --- Writing

void CommunicationChange::write()
{
    enter(State::Writing);
    read(triesToCompare, [this](const std::optional<settings::Values>& held) {
        if (!held)
            return fail(ChangeProblem::WriteFailed, {{}, {}, {FailureCode::NoAnswer, 0, {}}, {}});
        const settings::Values wanted = valuesOf(target());
        for (auto it = wanted.constBegin(); it != wanted.constEnd(); ++it) {
            if (held->value(it.key(), -1) != it.value())
                m_toWrite.append({it.key(), it.value()});
        }
        writeNext();
    });
}

void CommunicationChange::writeNext()
{
    if (stopForCancel())
        return;
    if (m_toWrite.isEmpty())
        return m_mustSave ? save() : verify();
    const settings::ItemValue next = m_toWrite.takeFirst();
    m_touched = true;
    ask(writeOf(next.item, next.value), [this, next](const ports::Outcome& outcome) {
        if (isConnectionGone(outcome))
            fail(ChangeProblem::Disconnected, {{}, next.item, outcome.failure, {}});
        else if (outcome.status == Status::Refused)
            fail(ChangeProblem::WriteFailed, {{}, next.item, outcome.failure, {}});
        else
            compareWritten(next, outcome.failure);
    });
}

void CommunicationChange::compareWritten(const settings::ItemValue& written, const ports::Failure& wire)
{
    read(triesToCompare, [this, written, wire](const std::optional<settings::Values>& held) {
        if (held && held->value(written.item, -1) == written.value)
            writeNext();
        else
            fail(ChangeProblem::WriteFailed, {{}, written.item, wire, {}});
    });
}

// --- Saving and resetting

void CommunicationChange::save()
{
    enter(State::Saving);
    if (!m_goesBack)
        m_saveTried = true;
    ports::Request request = writeOf(ItemId::SetValueSaving, 0);
    request.timeoutMs = m_timing.saveMs;
    ask(request, [this](const ports::Outcome& outcome) { saved(outcome); });
}

void CommunicationChange::saved(const ports::Outcome& outcome)
{
    if (isConnectionGone(outcome))
        return fail(ChangeProblem::Disconnected, {{}, ItemId::SetValueSaving, outcome.failure, {}});
    if (outcome.status == Status::Refused)
        return fail(ChangeProblem::SaveFailed, {{}, ItemId::SetValueSaving, outcome.failure, {}});
    // It may be silent for a while yet: what is sent meanwhile would be lost.
    const int tries = std::max(triesToCompare, m_timing.saveMs / m_timing.readPauseMs);
    read(tries, [this, outcome](const std::optional<settings::Values>& held) {
        if (outcome.status != Status::Done || !held)
            return fail(ChangeProblem::SaveUnknown, {{}, ItemId::SetValueSaving, outcome.failure, {}});
        if (stopForCancel())
            return;
        m_mustReset ? reset() : verify();
    });
}

void CommunicationChange::reset()
{
    enter(State::Resetting);
    ask(writeOf(ItemId::ResettingCommunicationSettings, 0),
        [this](const ports::Outcome& outcome) { resetEnded(outcome); });
}

void CommunicationChange::resetEnded(const ports::Outcome& outcome)
{
    if (outcome.status == Status::Refused)
        fail(ChangeProblem::ResetFailed, {{}, ItemId::ResettingCommunicationSettings, outcome.failure, {}});
    else
        reopen(); // without an answer, asking with both settings tells how it ended
}

// --- Finding it again

void CommunicationChange::reopen()
{
    m_askedElsewhere = false;
    m_sensorAt.reset();
    enter(State::Reopening);
    waitFor(target());
}

void CommunicationChange::waitFor(const ports::ConnectionUrl& url)
{
    m_scheduler.cancel(m_timer);
    m_timer = m_scheduler.after(m_timing.reopenMs, this, [this] {
        m_timer = 0;
        notReached();
    });
    if (isSamePlace(m_session->url(), url))
        m_session->retryNow();
    else
        goTo(url);
    connectionChanged();
}

void CommunicationChange::goTo(const ports::ConnectionUrl& url)
{
    ports::ConnectionUrl next = m_session->url(); // the type may have been stated meanwhile
    next.serial = url.serial;
    next.unit = url.unit;
    m_session->moveTo(next);
}

void CommunicationChange::notReached()
{
    const ports::LinkReport report = m_session->linkReport();
    if (m_session->isSensorNotReady())
        return waitFor(m_session->url()); // it is there: somebody stands at its keys
    if (!std::exchange(m_askedElsewhere, true))
        return waitFor(m_goesBack ? m_new : m_former);
    goTo(target()); // where it will be, at the latest, after its power has been off
    fail(ChangeProblem::NoAnswer, {{}, {}, {}, report});
}

void CommunicationChange::connectionChanged()
{
    if (!m_session)
        return;
    const Connection now = m_session->connection();
    if (m_state == State::Reopening && now == Connection::Ready) {
        m_scheduler.cancel(std::exchange(m_timer, 0));
        m_sensorAt = m_session->url();
        if (m_askedElsewhere)
            fail(ChangeProblem::StillOld);
        else
            verify();
    } else if (isRunning() && now == Connection::Closed) {
        fail(ChangeProblem::Disconnected);
    } else if (canSearch() && now == Connection::Ready && m_failure.problem == ChangeProblem::NoAnswer) {
        searchAgain(); // it has come back by itself
    } else {
        Q_EMIT changed();
    }
}

void CommunicationChange::verify()
{
    enter(State::Verifying);
    read(triesToCompare, [this](const std::optional<settings::Values>& held) {
        if (!held)
            fail(ChangeProblem::Disconnected);
        else if (*held != valuesOf(target()))
            fail(ChangeProblem::OtherValues);
        else
            end(m_goesBack ? State::WentBack : State::Done);
    });
}

// --- Asking

/// Puts back what was written before a person thought better of it.
bool CommunicationChange::stopForCancel()
{
    if (!m_cancelled)
        return false;
    if (m_touched)
        turnBack(false); // before the reset the sensor speaks as ever
    else
        fail(ChangeProblem::Cancelled);
    return true;
}

void CommunicationChange::ask(const ports::Request& request, SensorSession::Answer answer)
{
    if (m_session && m_session->ask(m_lease, request, m_run.get(), answer))
        return;
    ports::Outcome outcome;
    outcome.kind = request.kind;
    outcome.failure.code = FailureCode::NotConnected;
    m_scheduler.after(0, m_run.get(), [answer = std::move(answer), outcome] { answer(outcome); });
}

void CommunicationChange::read(int tries, std::function<void(const std::optional<settings::Values>&)> handler)
{
    ports::Request request;
    request.urgency = ports::Urgency::Procedure;
    request.items = {ItemId::CommunicationSpeed, ItemId::ParityStopBit, ItemId::DeviceAddress};
    ask(request, [this, tries, handler = std::move(handler)](const ports::Outcome& outcome) {
        if (outcome.status == Status::Done)
            return handler(outcome.values);
        const bool refusedForGood =
            outcome.status == Status::Refused && outcome.failure.code != FailureCode::NotReady;
        if (tries <= 1 || refusedForGood || isConnectionGone(outcome))
            return handler(std::nullopt);
        m_scheduler.after(m_timing.readPauseMs, m_run.get(),
                          [this, tries, handler] { read(tries - 1, handler); });
    });
}

} // namespace lds::procedures

#include "communication_change.h"

#include "catalog.h"
#include "serial_choices.h"

#include <algorithm>

namespace lds::procedures {

using sensor::SensorSession;

CommunicationChange::CommunicationChange(SensorSession& session, const sensor::Workspace& workspace,
                                         ports::LinkFactory& links, ports::Scheduler& scheduler,
                                         QObject* parent)
    : QObject(parent)
    , m_session(&session)
    , m_workspace(workspace)
    , m_links(links)
    , m_scheduler(scheduler)
    , m_former(session.url())
    , m_new(session.url())
{
    connect(&session, &SensorSession::connectionChanged, this, &CommunicationChange::connectionChanged);
    connect(&session, &SensorSession::readinessChanged, this, &CommunicationChange::changed);
    connect(&session, &SensorSession::busyChanged, this, &CommunicationChange::changed);
    connect(&session, &QObject::destroyed, this, [this] {
        if (isRunning())
            fail(ChangeProblem::Disconnected);
    });
}

CommunicationChange::~CommunicationChange()
{
    if (m_probe)
        m_probe->shutDown();
    m_scheduler.cancel(m_timer);
}

ChangeProblem CommunicationChange::obstacle(const ports::SerialSettings& serial, quint8 unit) const
{
    if (!m_session || isRunning() || !m_session->canWrite())
        return ChangeProblem::NotPossibleNow;
    ports::ConnectionUrl wanted = m_session->url();
    if (wanted.protocol != ports::Protocol::ModbusRtu || !ports::speedCode(serial.baud) || unit < 1 ||
        unit > 247)
        return ChangeProblem::NotPossibleNow;
    if (wanted.serial == serial && wanted.unit == unit)
        return ChangeProblem::NothingToChange;
    const auto sharesPort = [this](const SensorSession* other) {
        return other != m_session && other->connection() != sensor::Connection::Closed &&
               other->url().protocol == ports::Protocol::ModbusRtu &&
               other->url().host == m_session->url().host;
    };
    if (wanted.serial != serial && std::ranges::any_of(m_workspace.sessions(), sharesPort))
        return ChangeProblem::OthersOnLine;
    wanted.unit = unit;
    const SensorSession* other = m_workspace.find(wanted);
    return other && other != m_session ? ChangeProblem::AddressInList : ChangeProblem::None;
}

bool CommunicationChange::isRunning() const
{
    return m_state >= State::Checking && m_state <= State::Verifying;
}

CommunicationChange::StepState CommunicationChange::stepState(State step) const
{
    return m_steps[std::size_t(step)];
}

bool CommunicationChange::start(const ports::SerialSettings& serial, quint8 unit)
{
    if (obstacle(serial, unit) != ChangeProblem::None)
        return false;
    m_former = m_session->url();
    m_new = m_former;
    m_new.serial = serial;
    m_new.unit = unit;
    m_goesBack = m_touched = m_saveTried = false;
    m_mustSave = m_mustReset = true;
    m_sensorAt = m_former;
    if (!begin())
        return false;
    if (m_new.unit != m_former.unit)
        check();
    else {
        skip(State::Checking);
        write();
    }
    return true;
}

/// A new run, there or back. False when the lease is not to be had.
bool CommunicationChange::begin()
{
    m_lease = m_session->leases().acquire();
    if (!m_lease.isHeld())
        return false;
    m_run = std::make_unique<QObject>();
    m_steps.fill(StepState::Waiting);
    m_failure = {};
    m_cancelled = false;
    m_toWrite.clear();
    return true;
}

void CommunicationChange::cancel()
{
    if (!canCancel())
        return;
    if (m_state == State::Checking)
        return fail(ChangeProblem::Cancelled);
    if (m_state == State::Reopening) {
        m_sensorAt.reset();
        return fail(ChangeProblem::NoAnswer, {{}, {}, {}, m_session->linkReport()}); // keeps trying by itself
    }
    m_cancelled = true;
    Q_EMIT changed();
}

bool CommunicationChange::canCancel() const
{
    const bool beforeReset =
        m_state == State::Checking || m_state == State::Writing || m_state == State::Saving;
    return (beforeReset && !m_goesBack && !m_cancelled) || m_state == State::Reopening;
}

bool CommunicationChange::canGoBack() const
{
    return m_state == State::Failed && m_touched && m_sensorAt && m_session && m_session->isReady() &&
           m_session->canWrite();
}

void CommunicationChange::goBack()
{
    if (!canGoBack())
        return;
    if (begin())
        turnBack(!isSamePlace(*m_sensorAt, m_former));
}

void CommunicationChange::turnBack(bool mustReset)
{
    m_goesBack = true;
    m_mustSave = m_saveTried;
    m_mustReset = mustReset;
    m_cancelled = false;
    m_toWrite.clear();
    m_steps.fill(StepState::Waiting);
    skip(State::Checking);
    if (!m_mustSave)
        skip(State::Saving);
    if (!m_mustReset) {
        skip(State::Resetting);
        skip(State::Reopening);
    }
    write();
}

bool CommunicationChange::canSearch() const
{
    return m_state == State::Failed && !m_sensorAt && m_session &&
           m_session->connection() != sensor::Connection::Closed;
}

void CommunicationChange::searchAgain()
{
    if (!canSearch())
        return;
    const auto steps = m_steps;
    if (!begin())
        return;
    m_steps = steps;
    step_(State::Verifying) = StepState::Waiting;
    reopen();
}

void CommunicationChange::enter(State step)
{
    if (isRunning() && m_state != step)
        step_(m_state) = StepState::Done;
    m_state = step;
    step_(step) = StepState::UnderWay;
    Q_EMIT changed();
}

void CommunicationChange::fail(ChangeProblem problem, const ChangeFailure& details)
{
    if (!isRunning())
        return;
    m_failure = details;
    m_failure.problem = problem;
    step_(m_state) = StepState::Failed;
    end(State::Failed);
}

void CommunicationChange::end(State state)
{
    if (state != State::Failed)
        step_(m_state) = StepState::Done;
    m_state = state;
    m_scheduler.cancel(std::exchange(m_timer, 0));
    if (m_probe)
        m_probe->shutDown();
    m_probe.clear();
    m_run.release()->deleteLater(); // one of its answers may be what brought us here
    m_lease.release();
    const QPointer<CommunicationChange> alive(this);
    Q_EMIT changed();
    if (alive)
        Q_EMIT ended();
}

bool CommunicationChange::isSamePlace(const ports::ConnectionUrl& left, const ports::ConnectionUrl& right)
{
    return left.serial == right.serial && left.unit == right.unit;
}

settings::Values CommunicationChange::valuesOf(const ports::ConnectionUrl& url)
{
    return {{ItemId::CommunicationSpeed, ports::speedCode(url.serial.baud).value_or(0)},
            {ItemId::ParityStopBit, ports::parityCode(url.serial.parity)},
            {ItemId::DeviceAddress, url.unit}};
}

} // namespace lds::procedures

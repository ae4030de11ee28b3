#include "fake_sensor.h"

#include "fake_link.h"
#include "rules.h"

#include <algorithm>
#include <array>

namespace lds::support {

using namespace ports;

namespace {

settings::Values defaultValues(catalog::SensorModel model)
{
    settings::Values values;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (item.isReadable() && item.modbus)
            values.insert(item.id, item.limitsFor(model).defaultValue);
    }
    return values;
}

bool isBankScoped(ItemId item) { return catalog::hlG2(item).scope == catalog::Scope::Bank; }

} // namespace

FakeSensor::FakeSensor(catalog::SensorModel model)
    : m_model(model)
    , m_defaults(defaultValues(model))
    , m_values(m_defaults)
{
    m_values.insert(ItemId::BankSwitching, 1);
}

void FakeSensor::switchBank(Value bank)
{
    const Value running = m_values.value(ItemId::BankSwitching);
    if (bank == running)
        return;
    const settings::Values next = m_banks.value(int(bank), m_defaults);
    m_banks.insert(int(running), m_values);
    for (auto it = m_values.begin(); it != m_values.end(); ++it) {
        if (isBankScoped(it.key()))
            it.value() = next.value(it.key());
    }
    m_values.insert(ItemId::BankSwitching, bank);
}

void FakeSensor::refuse(ItemId item, FailureCode code) { m_refused.insert(item, code); }

void FakeSensor::setNotReady(bool notReady)
{
    m_notReady = notReady;
    refusePoll(notReady ? FailureCode::NotReady : FailureCode::None);
}

void FakeSensor::opening(FakeLink* link)
{
    ++m_openings;
    m_link = link;
    m_statistics = {};
    Q_EMIT link->reported({LinkState::Opening, OpenFailure::None, {}, true});
    const OpenFailure failure = m_openFailure != OpenFailure::None ? m_openFailure
                                : m_notReady                       ? OpenFailure::NotReady
                                                                   : OpenFailure::None;
    m_open = failure == OpenFailure::None;
    Q_EMIT link->reported({m_open ? LinkState::Open : LinkState::Failed, failure, m_openDetail, true});
}

void FakeSensor::closing()
{
    for (const Waiting& waiting : std::exchange(m_waiting, {}))
        end(waiting.request, Status::Unknown, FailureCode::ConnectionLost);
    m_open = false;
    m_pollIntervalMs = 0;
    if (m_link)
        Q_EMIT m_link->reported({LinkState::Closed, OpenFailure::None, {}, true});
}

void FakeSensor::cut()
{
    for (const Waiting& waiting : std::exchange(m_waiting, {}))
        end(waiting.request, Status::Unknown, FailureCode::ConnectionLost);
    m_open = false;
    m_pollIntervalMs = 0;
    if (m_link)
        Q_EMIT m_link->reported({LinkState::Failed, OpenFailure::Lost, QStringLiteral("cut"), true});
}

void FakeSensor::failOpenings(OpenFailure failure, const QString& detail)
{
    m_openFailure = failure;
    m_openDetail = detail;
}

void FakeSensor::arrived(const Request& request)
{
    if (!m_open)
        return end(request, Status::Unknown, FailureCode::NotConnected);
    if (request.kind == RequestKind::Write && m_link->isViewOnly())
        return end(request, Status::Refused, FailureCode::ViewOnly);
    m_requests.append(request);
    if (const auto hook = m_onRequest) // a copy: it may put another in its place
        hook(request);
    if (!m_open)
        return end(request, Status::Unknown, FailureCode::ConnectionLost);

    std::optional<Carried> lost;
    if (request.kind == RequestKind::Read && m_lostReads > 0) {
        --m_lostReads;
        lost = Carried::Not;
    }
    for (const settings::ItemValue& written : request.write) {
        if (m_losses.contains(written.item))
            lost = m_losses.take(written.item);
    }
    if (lost == Carried::Out)
        carryOut(request.write);
    if (lost || m_hold)
        m_waiting.append({request, lost});
    else
        answer(request);
}

void FakeSensor::deliver()
{
    if (!m_waiting.isEmpty())
        answer(m_waiting.takeFirst().request);
}

void FakeSensor::deliverNewest()
{
    if (!m_waiting.isEmpty())
        answer(m_waiting.takeLast().request);
}

void FakeSensor::deliverAll()
{
    for (const Waiting& waiting : std::exchange(m_waiting, {}))
        answer(waiting.request);
}

void FakeSensor::timeOut()
{
    for (const Waiting& waiting : std::exchange(m_waiting, {}))
        end(waiting.request, Status::Unknown, FailureCode::NoAnswer);
}

void FakeSensor::answerLate(RequestId id, const settings::Values& values)
{
    if (m_link)
        Q_EMIT m_link->finished({id, RequestKind::Read, Status::Done, values, {}, m_link->nowNs()});
}

void FakeSensor::answer(const Request& request)
{
    if (m_notReady)
        return end(request, Status::Refused, FailureCode::NotReady);
    if (request.kind == RequestKind::Write) {
        const Failure failure = carryOut(request.write);
        return end(request, failure.code == FailureCode::None ? Status::Done : Status::Refused, failure.code);
    }
    if (m_refuseReads != FailureCode::None)
        return end(request, Status::Refused, m_refuseReads);
    settings::Values read;
    for (const ItemId item : request.items) {
        if (m_values.contains(item))
            read.insert(item, m_values.value(item));
    }
    end(request, Status::Done, FailureCode::None, read);
}

void FakeSensor::end(const Request& request, Status status, FailureCode code, const settings::Values& values)
{
    if (m_link)
        Q_EMIT m_link->finished({request.id, request.kind, status, values, {code, 0, {}}, m_link->nowNs()});
}

Failure FakeSensor::carryOut(const settings::Write& write)
{
    for (const settings::ItemValue& written : write) {
        if (m_refused.contains(written.item))
            return {m_refused.value(written.item), 3, {}};
    }
    if (write.isEmpty())
        return {FailureCode::ValueRefused, 3, {}};
    if (m_judge) {
        const Verdict verdict = m_judge(m_values, write);
        if (!verdict)
            return verdict.error();
        m_values = *verdict;
        return {};
    }
    if (catalog::hlG2(write.first().item).role != catalog::Role::Setting) {
        carryOutCommand(write.first().item, write.first().value);
        return {};
    }
    const auto verdict = settings::apply(m_model, m_values, write);
    if (!verdict)
        return {FailureCode::ValueRefused, 3, {}};
    m_values = *verdict;
    return {};
}

void FakeSensor::carryOutCommand(ItemId item, Value value)
{
    if (item == ItemId::BankSwitching)
        return switchBank(value);
    if (item == ItemId::SettingsInitialization) {
        for (auto it = m_values.begin(); it != m_values.end(); ++it) {
            if (isBankScoped(it.key()))
                it.value() = m_defaults.value(it.key());
        }
        return;
    }
    if (m_values.contains(item))
        m_values.insert(item, value);
}

void FakeSensor::emitMeasurement(const measurement::Measurement& sample) { emitBatch({sample}); }

void FakeSensor::emitBatch(const measurement::MeasurementBatch& batch)
{
    m_statistics.answered += quint64(batch.size());
    if (m_link)
        Q_EMIT m_link->measured(batch, m_statistics);
}

void FakeSensor::refusePoll(FailureCode code)
{
    if (m_link)
        Q_EMIT m_link->pollRefused({code, 0, {}});
}

int FakeSensor::count(RequestKind kind) const
{
    return int(std::count_if(m_requests.begin(), m_requests.end(),
                             [kind](const Request& request) { return request.kind == kind; }));
}

int FakeSensor::readsOf(ItemId item) const
{
    return int(std::count_if(m_requests.begin(), m_requests.end(), [item](const Request& request) {
        return request.kind == RequestKind::Read && request.items.contains(item);
    }));
}

int FakeSensor::writesOf(ItemId item) const
{
    return int(std::count_if(m_requests.begin(), m_requests.end(), [item](const Request& request) {
        return request.kind == RequestKind::Write &&
               std::any_of(request.write.begin(), request.write.end(),
                           [item](const settings::ItemValue& written) { return written.item == item; });
    }));
}

} // namespace lds::support

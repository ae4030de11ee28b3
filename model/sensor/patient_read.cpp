#include "patient_read.h"

namespace lds::sensor {

using ports::FailureCode;
using ports::Status;

bool isConnectionGone(const ports::Outcome& outcome)
{
    return outcome.status == Status::Unknown && (outcome.failure.code == FailureCode::ConnectionLost ||
                                                 outcome.failure.code == FailureCode::NotConnected);
}

void PatientRead::start(const QList<ItemId>& items, const QList<ItemId>& own, Patience patience,
                        Handler handler)
{
    m_items.clear();
    for (const ItemId item : items) {
        if (m_host.linkReaches(item) && !m_items.contains(item))
            m_items.append(item);
    }
    m_own = own;
    m_patience = patience;
    m_handler = std::move(handler);
    if (m_items.isEmpty())
        return std::exchange(m_handler, {})(End::Read, {}, {});
    attempt();
}

void PatientRead::attempt()
{
    --m_patience.tries;
    ports::Request request;
    request.kind = ports::RequestKind::Read;
    request.urgency = ports::Urgency::Person;
    request.items = m_items;
    m_host.ask(request, &m_context, [this](const ports::Outcome& outcome) { answered(outcome); });
}

void PatientRead::answered(const ports::Outcome& outcome)
{
    if (outcome.status == Status::Done) {
        const HeldValues::Changes changes = m_host.learn(outcome.values, outcome.finishedNs, m_own);
        return std::exchange(m_handler, {})(End::Read, outcome.values, changes);
    }
    if (isConnectionGone(outcome))
        return std::exchange(m_handler, {})(End::ConnectionGone, {}, {});
    const bool notReady = outcome.failure.code == FailureCode::NotReady;
    const bool refusedForGood = outcome.status == Status::Refused && !notReady;
    if (m_patience.tries > 0 && !refusedForGood) {
        m_host.later(m_patience.pauseMs, &m_context, [this] { attempt(); });
        return;
    }
    std::exchange(m_handler, {})(notReady ? End::NotReady : End::Failed, {}, {});
}

} // namespace lds::sensor

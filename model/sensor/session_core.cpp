#include "session_core.h"

namespace lds::sensor {

SensorSession::Private::Private(SensorSession* session, ports::ConnectionUrl address,
                                ports::LinkFactory& factory, ports::Scheduler& clock)
    : q(session)
    , url(std::move(address))
    , links(factory)
    , scheduler(clock)
    , desk([this] { Turn turn(*this); })
    , announcer(session)
{}

SensorSession::Private::~Private() = default;

SensorSession::Private::Turn::~Turn()
{
    if (m_core.depth > 1) {
        --m_core.depth;
        return;
    }
    // Still inside the turn: what ends here may give the lease back, which is a turn of its own.
    m_core.retiredApplies.clear();
    m_core.retiredCommands.clear();
    const quint32 busy =
        (m_core.canWrite() ? 1U : 0U) | (m_core.applying ? 2U : 0U) | (m_core.running ? 4U : 0U);
    if (std::exchange(m_core.toldBusy, busy) != busy)
        m_core.announcer.add(Announcer::News::Busy);
    --m_core.depth;
    m_core.announcer.tell(); // the session may be gone afterwards
}

catalog::SensorModel SensorSession::Private::sensorModel() const
{
    if (url.sensor)
        return *url.sensor;
    for (int index = 0; index < catalog::modelCount; ++index) {
        const auto model = catalog::SensorModel(index);
        if (fit & catalog::maskOf(model))
            return model;
    }
    return catalog::SensorModel::HlG203;
}

void SensorSession::Private::ask(const ports::Request& request, QObject* context, Handler handler)
{
    if (!client)
        return;
    client->submit(request, context, [this, handler = std::move(handler)](const ports::Outcome& outcome) {
        Turn turn(*this);
        handler(outcome);
    });
}

void SensorSession::Private::later(int delayMs, QObject* context, std::function<void()> callback)
{
    scheduler.after(delayMs, context, [this, callback = std::move(callback)] {
        Turn turn(*this);
        callback();
    });
}

void SensorSession::Private::setSaved(Saved next)
{
    if (std::exchange(saved, next) != next)
        announcer.add(Announcer::News::Saved);
}

} // namespace lds::sensor

#include "announcer.h"

#include "sensor_session.h"

#include <QPointer>

namespace lds::sensor {

void Announcer::addHeld(const QList<ItemId>& items)
{
    for (const ItemId item : items) {
        if (!m_held.contains(item))
            m_held.append(item);
    }
}

void Announcer::tell()
{
    if (m_telling)
        return;
    m_telling = true;
    const QPointer<SensorSession> alive(m_session);
    while (const Tell next = takeNext()) {
        next();
        if (!alive)
            return; // and this object is gone as well
    }
    m_telling = false;
}

void Announcer::tellLast()
{
    m_telling = true;
    while (!m_tell.empty()) {
        const Tell next = std::move(m_tell.front());
        m_tell.pop_front();
        next();
    }
}

Announcer::Tell Announcer::takeNext()
{
    SensorSession* const session = m_session;
    for (quint32 news = 0; news < quint32(News::Count); ++news) {
        if (m_news & (1U << news)) {
            m_news &= ~(1U << news);
            return tellOf(News(news));
        }
        // What is held is told after who and how it is, and before what follows from it.
        if (News(news) == News::Readiness && !m_held.isEmpty())
            return [session, items = std::exchange(m_held, {})] { Q_EMIT session->heldChanged(items); };
    }
    if (m_tell.empty())
        return {};
    Tell next = std::move(m_tell.front());
    m_tell.pop_front();
    return next;
}

Announcer::Tell Announcer::tellOf(News news) const
{
    SensorSession* const session = m_session;
    switch (news) {
    case News::Connection:
        return [session] { Q_EMIT session->connectionChanged(); };
    case News::Identity:
        return [session] { Q_EMIT session->identityChanged(); };
    case News::Readiness:
        return [session] { Q_EMIT session->readinessChanged(); };
    case News::Saved:
        return [session] { Q_EMIT session->savedChanged(); };
    case News::Pending:
        return [session] { Q_EMIT session->pendingChanged(); };
    case News::Busy:
        return [session] { Q_EMIT session->busyChanged(); };
    case News::Measured:
        return [session] { Q_EMIT session->measured(); };
    case News::Count:
        break;
    }
    return {};
}

} // namespace lds::sensor

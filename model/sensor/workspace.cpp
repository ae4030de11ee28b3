#include "workspace.h"

#include <algorithm>

namespace lds::sensor {

bool isSameSensor(const ports::ConnectionUrl& left, const ports::ConnectionUrl& right)
{
    if (left.protocol != right.protocol)
        return false;
    if (left.protocol == ports::Protocol::ModbusRtu)
        return left.host == right.host && left.unit == right.unit;
    return left.port == right.port && left.host.compare(right.host, Qt::CaseInsensitive) == 0;
}

Workspace::Workspace(ports::LinkFactory& links, ports::Scheduler& scheduler, QObject* parent)
    : QObject(parent)
    , m_links(links)
    , m_scheduler(scheduler)
{}

Workspace::~Workspace() = default;

SensorSession* Workspace::add(const ports::ConnectionUrl& url, const QString& name)
{
    if (SensorSession* const session = find(url)) {
        setCurrent(session);
        return session;
    }
    auto* session = new SensorSession(url, m_links, m_scheduler, this);
    session->setName(name);
    m_sessions.append(session);
    Q_EMIT added(session);
    setCurrent(session);
    return session;
}

void Workspace::remove(SensorSession* session)
{
    const qsizetype index = m_sessions.indexOf(session);
    if (index < 0)
        return;
    Q_EMIT aboutToRemove(session);
    if (!m_sessions.removeOne(session))
        return; // a slot has removed it already
    session->close();
    if (m_current == session) {
        m_current = m_sessions.isEmpty() ? nullptr : m_sessions.at(std::min(index, m_sessions.size() - 1));
        Q_EMIT currentChanged(m_current);
    }
    session->deleteLater(); // this may be one of its own signals
}

const QList<SensorSession*>& Workspace::sessions() const { return m_sessions; }

SensorSession* Workspace::find(const ports::ConnectionUrl& url) const
{
    const auto found = std::ranges::find_if(
        m_sessions, [&url](const SensorSession* session) { return isSameSensor(session->url(), url); });
    return found == m_sessions.end() ? nullptr : *found;
}

SensorSession* Workspace::current() const { return m_current; }

void Workspace::setCurrent(SensorSession* session)
{
    if (m_current == session || !m_sessions.contains(session))
        return;
    m_current = session;
    Q_EMIT currentChanged(session);
}

int Workspace::pendingCount() const
{
    int count = 0;
    for (const SensorSession* session : m_sessions)
        count += session->pending().count();
    return count;
}

int Workspace::unsavedCount() const
{
    return int(std::count_if(m_sessions.begin(), m_sessions.end(), [](const SensorSession* session) {
        return session->saved() == Saved::NotSaved;
    }));
}

} // namespace lds::sensor

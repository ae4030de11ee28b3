#include "recent_connections.h"

#include "workspace.h"

#include <QSettings>

namespace lds::ui {

namespace {
const QString arrayKey = QStringLiteral("connections/recent");
const QString urlKey = QStringLiteral("url");
const QString nameKey = QStringLiteral("name");
} // namespace

RecentConnections::RecentConnections(QSettings& settings)
    : m_settings(settings)
{}

QList<RecentConnection> RecentConnections::list() const
{
    QList<RecentConnection> connections;
    const int size = qMin(m_settings.beginReadArray(arrayKey), most);
    for (int index = 0; index < size; ++index) {
        m_settings.setArrayIndex(index);
        if (const auto url = ports::parseConnectionUrl(m_settings.value(urlKey).toString()))
            connections += {*url, m_settings.value(nameKey).toString()};
    }
    m_settings.endArray();
    return connections;
}

void RecentConnections::add(const RecentConnection& connection)
{
    QList<RecentConnection> connections = list();
    connections.removeIf(
        [&](const RecentConnection& other) { return sensor::isSameSensor(other.url, connection.url); });
    connections.prepend(connection);
    if (connections.size() > most)
        connections.resize(most);
    m_settings.remove(arrayKey);
    m_settings.beginWriteArray(arrayKey);
    for (int index = 0; index < int(connections.size()); ++index) {
        m_settings.setArrayIndex(index);
        m_settings.setValue(urlKey, connections.at(index).url.toString());
        m_settings.setValue(nameKey, connections.at(index).name);
    }
    m_settings.endArray();
}

} // namespace lds::ui

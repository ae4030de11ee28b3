#pragma once

#include "sensor_session.h"

#include <QObject>

namespace lds::sensor {

/// Whether both lead to one sensor: same host and port over TCP, same port and unit over RS-485 (two units
/// of one address cannot share a line, whatever their speeds).
bool isSameSensor(const ports::ConnectionUrl& left, const ports::ConnectionUrl& right);

/// The sensors a person has on the table, in their order, and the one they look at.
class Workspace final : public QObject {
    Q_OBJECT

public:
    Workspace(ports::LinkFactory& links, ports::Scheduler& scheduler, QObject* parent = nullptr);
    ~Workspace() override;

    /// Adds a session for the URL, makes it current and returns it. It is not opened yet. A URL that is
    /// there already (isSameSensor) makes that session current and returns it instead.
    SensorSession* add(const ports::ConnectionUrl& url, const QString& name = {});
    void remove(SensorSession* session); ///< Closes and deletes; the neighbour becomes current.
    const QList<SensorSession*>& sessions() const;
    SensorSession*
    find(const ports::ConnectionUrl& url) const; ///< By isSameSensor(); nullptr when not there.
    SensorSession* current() const;              ///< nullptr when there are none.
    void setCurrent(SensorSession* session);
    int pendingCount() const; ///< Over all sensors.
    int unsavedCount() const; ///< Sensors with Saved::NotSaved.

Q_SIGNALS:
    void added(lds::sensor::SensorSession* session);
    void aboutToRemove(lds::sensor::SensorSession* session);
    void currentChanged(lds::sensor::SensorSession* session);

private:
    ports::LinkFactory& m_links;
    ports::Scheduler& m_scheduler;
    QList<SensorSession*> m_sessions;
    SensorSession* m_current = nullptr;
};

} // namespace lds::sensor

#pragma once

#include "workspace.h"

#include <QAbstractListModel>

namespace lds::ui {

/// The sensors of the workspace as lines of a list: name, type and what is the matter, URL, state.
class SensorListModel final : public QAbstractListModel {
    Q_OBJECT

public:
    enum class State { Good, Warning, Busy, Offline };
    enum Role { StateRole = Qt::UserRole, DetailRole, UrlRole, EditsRole };

    SensorListModel(sensor::Workspace& workspace, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    sensor::SensorSession* sessionAt(const QModelIndex& index) const;
    QModelIndex indexOf(const sensor::SensorSession* session) const;

private:
    void add(sensor::SensorSession* session);
    void removing(sensor::SensorSession* session);
    void changed(sensor::SensorSession* session);

    QList<sensor::SensorSession*> m_sessions; ///< The workspace's, as far as the view knows of them.
};

/// What the list shows of one sensor.
SensorListModel::State sensorState(const sensor::SensorSession& session);
QString sensorDetail(const sensor::SensorSession& session);

} // namespace lds::ui

#pragma once

#include "sensor_session.h"

#include <QAbstractTableModel>
#include <QPointer>

namespace lds::ui {

/// The pending edits as rows: what the sensor holds, what it will hold. An address is one row.
class ReviewTableModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Menu, Item, Held, Wanted, Unit, Note, ColumnCount };
    struct Row {
        QList<catalog::ItemId> items;
        int menu = 0;
        QString name;
        QString held;
        QString wanted;
        QString unit;
        QString note; ///< Conflict, or what else to know; empty.
        bool conflict = false;
    };

    explicit ReviewTableModel(sensor::SensorSession& session, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    const QList<Row>& rows() const { return m_rows; }

private:
    void rebuild();

    QPointer<sensor::SensorSession> m_session;
    QList<Row> m_rows;
};

} // namespace lds::ui

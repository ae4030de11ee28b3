#pragma once

#include "bus_scan.h"

#include <QAbstractTableModel>
#include <QSet>

namespace lds::ui {

/// What a scan has found, line by line as it comes. Sensors can be ticked, to be added to the list.
class ScanFindingsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Address, Found, Settings, Note, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    void clear();
    /// `inList`: the workspace has this sensor with these settings already.
    void add(const ports::ScanFinding& finding, bool inList);
    const ports::ScanFinding& findingAt(int row) const { return m_rows.at(row).finding; }
    QList<ports::ScanFinding> ticked() const;

Q_SIGNALS:
    void tickedChanged();

private:
    struct Row {
        ports::ScanFinding finding;
        bool inList = false;
        bool ticked = false;
    };
    QString text(const Row& row, int column) const;

    QList<Row> m_rows;
};

} // namespace lds::ui

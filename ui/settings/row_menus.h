#pragma once

#include "sensor_session.h"
#include "setting_row.h"

#include <QObject>
#include <QPoint>

class QMenu;
class QWidget;

namespace lds::ui {

class SettingsModel;

/// What can be done with a row: the orders of one that acts at once, and the context menu of any.
class RowMenus final : public QObject {
    Q_OBJECT

public:
    explicit RowMenus(SettingsModel& model);

    void popUpOrders(const SettingRow& row, const QPoint& at, QWidget* parent);
    void popUpContext(const SettingRow& row, const QPoint& at, QWidget* parent);
    void revert(const SettingRow& row); ///< The edit and any wrong text; also "take the sensor's".
    void keepMine(const SettingRow& row);
    void copyValue(const SettingRow& row) const; ///< The new value where there is one, with its unit.
    void copyRow(const SettingRow& row) const;   ///< With tabs between, for a spreadsheet.
    void setToDefault(const SettingRow& row);    ///< As a pending edit.

Q_SIGNALS:
    void editRequested(const lds::ui::SettingRow* row);
    void detailsRequested();
    void commandRequested(lds::catalog::ItemId item, lds::catalog::Value value);

private:
    void addOrders(QMenu& menu, const SettingRow& row);
    void addEditing(QMenu& menu, const SettingRow& row);

    SettingsModel& m_model;
};

} // namespace lds::ui

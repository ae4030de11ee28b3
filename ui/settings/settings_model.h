#pragma once

#include "row_facts.h"
#include "sensor_session.h"
#include "setting_row.h"

#include <memory>
#include <QAbstractItemModel>
#include <QHash>
#include <QPointer>

namespace lds::ui {

/// The settings of one sensor as a tree by menu number. Follows its session: a value that changes
/// updates the row it stands in and no other; the model is reset only when another sensor is shown.
class SettingsModel final : public QAbstractItemModel {
    Q_OBJECT

public:
    enum Column { Menu, Item, InSensor, NewValue, Unit, Range, Default, ColumnCount };
    enum Role {
        RowRole = Qt::UserRole, ///< const SettingRow*
        StateRole,              ///< RowStates of the row, as int
        ButtonRole,             ///< New value only: the text of the row's button; empty without one
    };
    enum RowState {
        Edited = 1,
        Conflict = 2,   ///< The sensor's value has moved since the edit was made.
        Problem = 4,    ///< The row takes part in a rule that the edits would break.
        Stale = 8,      ///< Not connected: the value is the last known one.
        Missing = 16,   ///< There is no value to show.
        Unusable = 32,  ///< Cannot be changed here and now.
        WrongText = 64, ///< What was typed is no value; it waits to be put right.
    };
    Q_DECLARE_FLAGS(RowStates, RowState)

    explicit SettingsModel(QObject* parent = nullptr);
    ~SettingsModel() override;

    void setSession(sensor::SensorSession* session); ///< nullptr: the model is empty.
    sensor::SensorSession* session() const { return m_session; }

    const SettingRow* row(const QModelIndex& index) const; ///< nullptr for an invalid index.
    QModelIndex indexOf(const SettingRow* row, int column = Menu) const;
    QModelIndex indexOf(catalog::ItemId item, int column = Menu) const; ///< Invalid: not a row.
    const SettingTree* tree() const { return m_tree.get(); }            ///< nullptr without a session.
    RowStates states(const SettingRow& row) const;
    /// The rules that the row takes part in and the edits would break, as sentences.
    QStringList problems(const SettingRow& row) const;
    /// Everything a person may look for: number, names, keys, values, help; in lower case.
    QString searchText(const SettingRow& row) const;
    QStringList valueTexts(const SettingRow& row) const; ///< In the sensor and new, as on screen.

    /// Text that was typed and is no value, kept so that nothing entered is lost. One per row and sensor.
    struct WrongInput {
        QString text;
        QString message; ///< What is wrong with it and what to do.
    };
    void keepWrongInput(const SettingRow& row, const WrongInput& input); ///< An empty text forgets it.
    WrongInput wrongInput(const SettingRow& row) const;
    bool hasWrongInput() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    struct Snapshot;
    using WrongInputs = QHash<const SettingRow*, WrongInput>;

    void follow();
    void heldChanged(const QList<catalog::ItemId>& items);
    void pendingChanged();
    void everythingChanged();
    void rowChanged(const SettingRow& row);
    Snapshot snapshot(const SettingRow& row) const;
    void takeSnapshots();
    void forget(const QObject* session);
    QString displayText(const SettingRow& row, int column) const;
    QString newValueText(const SettingRow& row) const;
    bool isStep(const SettingRow& row) const;
    QString buttonText(const SettingRow& row) const;
    QString rangeColumnText(const SettingRow& row) const;
    QString toolTip(const SettingRow& row, int column) const;
    QString accessibleText(const SettingRow& row, int column) const;

    std::shared_ptr<const SettingTree> m_tree;
    QPointer<sensor::SensorSession> m_session;
    QList<settings::Refusal> m_problems;
    QHash<const SettingRow*, Snapshot> m_snapshots;
    /// By sensor, so that looking at another one in between loses nothing. The trees stay with them.
    QHash<const QObject*, WrongInputs> m_wrongInputs;
    QHash<const catalog::Catalog*, std::shared_ptr<const SettingTree>> m_trees;
};
Q_DECLARE_OPERATORS_FOR_FLAGS(SettingsModel::RowStates)

} // namespace lds::ui

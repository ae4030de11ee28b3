#pragma once

#include <QPersistentModelIndex>
#include <QSortFilterProxyModel>
#include <QStringList>

namespace lds::ui {

class SettingsModel;
struct SettingRow;

/// Shows the rows a person looks for, with the headings above them. A word that begins a menu number
/// finds that number and below ("3" is all of Judgment) and values that are just that; any other word is
/// looked for in every text of a row. Several words must all match.
class SettingsFilter final : public QSortFilterProxyModel {
    Q_OBJECT

public:
    explicit SettingsFilter(SettingsModel& model, QObject* parent = nullptr);

    void setText(const QString& text);
    QString text() const { return m_text; }
    void setChangedOnly(bool changedOnly);
    bool isChangedOnly() const { return m_changedOnly; }
    bool isActive() const { return m_changedOnly || !m_words.isEmpty(); }
    /// A row that stays whatever the filter says: the one being edited must not vanish under the hands.
    void setPinned(const QModelIndex& sourceIndex);

protected:
    bool filterAcceptsRow(int sourceRow, const QModelIndex& sourceParent) const override;

private:
    bool matches(const SettingRow& row) const;
    bool beginsMenuNumber(const QString& word) const;
    bool wordMatches(const SettingRow& row, const QString& word) const;

    SettingsModel& m_model;
    QString m_text;
    QStringList m_words;
    bool m_changedOnly = false;
    QPersistentModelIndex m_pinned;
};

} // namespace lds::ui

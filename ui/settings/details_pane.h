#pragma once

#include "setting_row.h"

#include <QPersistentModelIndex>
#include <QScrollArea>

class QFrame;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace lds::ui {

class SettingsModel;
class WindowSketch;

/// Answers the next question about the current row: what it is, which rule holds it, what will change,
/// which address has it, and what to do about a conflict.
class DetailsPane final : public QScrollArea {
    Q_OBJECT

public:
    explicit DetailsPane(SettingsModel& model, QWidget* parent = nullptr);
    void setRow(const QModelIndex& sourceIndex); ///< Invalid: nothing chosen.
    void sessionChanged();
    const SettingRow* row() const;
    QString plainText() const; ///< Everything it says, for tests and screen readers.

Q_SIGNALS:
    void editRequested(const lds::ui::SettingRow* row);
    void keepMineRequested(const lds::ui::SettingRow* row);
    void takeSensorsRequested(const lds::ui::SettingRow* row);

private:
    struct Section {
        QLabel* heading = nullptr;
        QLabel* text = nullptr;
    };
    struct Notice {
        QFrame* frame = nullptr;
        QLabel* icon = nullptr;
        QLabel* text = nullptr;
        QList<QPushButton*> buttons;
    };

    void build();
    QLabel* addLabel(QVBoxLayout* layout, const char* property = nullptr);
    Section addSection(QVBoxLayout* layout, const QString& heading);
    Notice addNotice(QVBoxLayout* layout, const QString& objectName, const QList<QPushButton*>& buttons);
    void refresh();
    void refreshLater();
    void refreshNotices(const SettingRow& row);
    void refreshSections(const SettingRow& row);
    static void show(const Section& section, const QStringList& lines);
    void show(const Notice& notice, const QString& text) const;
    void applyTheme();

    SettingsModel& m_model;
    bool m_refreshQueued = false;
    QPersistentModelIndex m_index;
    QLabel* m_path = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_empty = nullptr;
    Notice m_wrong;
    Notice m_conflict;
    Notice m_problem;
    Notice m_whyNot;
    QLabel* m_help = nullptr;
    Section m_rules;
    WindowSketch* m_sketch = nullptr;
    Section m_change;
    Section m_values;
    Section m_addresses;
    QLabel* m_manual = nullptr;
};

} // namespace lds::ui

#pragma once

#include "row_editor.h"

#include <QComboBox>

namespace lds::ui {

/// The choices that this type of sensor has. Choosing in the list commits.
class ChoiceEditor final : public QComboBox, public RowEditor {
    Q_OBJECT

public:
    ChoiceEditor(const SettingRow& row, sensor::SensorSession& session, QWidget* parent);

    QString text() const override { return currentText(); }
    void restore(const QString&) override {}
    QString error() const override { return {}; } // nothing wrong can be chosen
    void commit() override;
    void insist() override {}

    void showPopup() override;
    void hidePopup() override;

Q_SIGNALS:
    void chosen(); ///< In the list, with Enter or the mouse.

private:
    bool m_listOpen = false;
};

} // namespace lds::ui

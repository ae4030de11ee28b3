#pragma once

#include "row_editor.h"

#include <QAbstractSpinBox>

namespace lds::ui {

class EditorMessage;

/// A length, factor, count, duration or port: exact decimal text, judged while it is typed. Up and Down
/// step by the setting resolution, Page Up and Page Down by ten of it, with Shift or Ctrl by a hundred.
class NumberEditor final : public QAbstractSpinBox, public RowEditor {
    Q_OBJECT

public:
    NumberEditor(const SettingRow& row, sensor::SensorSession& session, QWidget* parent);

    QString text() const override;
    void restore(const QString& text) override;
    QString error() const override;
    void commit() override;
    void insist() override;
    const EditorMessage& message() const { return *m_message; }

    void stepBy(int steps) override;

protected:
    StepEnabled stepEnabled() const override;
    QValidator::State validate(QString& input, int& position) const override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    using Parsed = tl::expected<settings::ParsedValue, settings::ParseFailure>;
    const catalog::SettingItem& item() const { return *row().first(); }
    Parsed parsed() const;
    void setValue(catalog::Value value);
    void review(); ///< Says what the sensor will make of the text.

    EditorMessage* m_message;
    QString m_original; ///< As it was before the person came: never wrong, whatever it is.
};

} // namespace lds::ui

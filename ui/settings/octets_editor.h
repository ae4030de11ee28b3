#pragma once

#include "row_editor.h"

#include <array>
#include <QFrame>

class QLineEdit;

namespace lds::ui {

class EditorMessage;

/// An address in four fields. A point or three digits go on to the next field, arrows and Backspace cross
/// from one to the other, and a whole address can be pasted into any of them.
class OctetsEditor final : public QFrame, public RowEditor {
    Q_OBJECT

public:
    OctetsEditor(const SettingRow& row, sensor::SensorSession& session, QWidget* parent);

    QString text() const override; ///< The four fields joined by points, as typed.
    void restore(const QString& text) override;
    QString error() const override;
    void commit() override;
    void insist() override;
    const EditorMessage& message() const { return *m_message; }
    QLineEdit* field(int octet) const { return m_fields.at(std::size_t(octet)); } ///< 0 is the 1st octet.

    QSize sizeHint() const override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    static constexpr int fieldCount = 4;

    bool keyPressed(int octet, const class QKeyEvent& event);
    bool pasteAddress(const QString& text);
    void enterField(int octet, bool atEnd = false);
    tl::expected<settings::Write, QString> parsed() const;
    void review();

    std::array<QLineEdit*, fieldCount> m_fields{};
    EditorMessage* m_message;
    QString m_original;
};

} // namespace lds::ui

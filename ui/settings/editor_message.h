#pragma once

#include <QFrame>

class QLabel;

namespace lds::ui {

/// What an editor has to say about its text, right under it (above it where there is no room). Lies over
/// the rows, is no window and takes no focus; goes where its editor goes and dies with it.
class EditorMessage final : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Note, Warning, Error };

    explicit EditorMessage(QWidget& editor);

    /// An empty text hides it.
    void setMessage(Kind kind, const QString& text);
    QString text() const { return m_text; }
    Kind kind() const { return m_kind; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();

    QWidget& m_editor;
    QLabel* m_icon;
    QLabel* m_label;
    QString m_text;
    Kind m_kind = Kind::Note;
};

} // namespace lds::ui

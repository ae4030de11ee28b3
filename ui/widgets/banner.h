#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace lds::ui {

/// A line that says what is the matter and offers what can be done, in place of a modal box.
class Banner final : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Information, Warning, Error };

    explicit Banner(QWidget* parent = nullptr);

    void setMessage(Kind kind, const QString& text);
    QString text() const;
    Kind kind() const { return m_kind; }
    /// An empty text hides the button.
    void setAction(const QString& text);
    /// Whether a person may put the line away; a state that still holds is not closable.
    void setClosable(bool closable);

Q_SIGNALS:
    void actionTriggered();
    void closed();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void applyTheme();

    Kind m_kind = Kind::Information;
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_action;
    QPushButton* m_close;
};

} // namespace lds::ui

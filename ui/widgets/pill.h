#pragma once

#include "theme.h"

#include <QWidget>

namespace lds::ui {

/// A word in a rounded frame with an icon before it: a state that stays in sight.
class Pill final : public QWidget {
    Q_OBJECT

public:
    enum class Kind { Quiet, Good, Warning, Bad };

    explicit Pill(QWidget* parent = nullptr);
    /// Also the accessible name.
    void setState(Kind kind, const QString& text);
    QString text() const { return m_text; }
    Kind kind() const { return m_kind; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QFont textFont() const;

    Kind m_kind = Kind::Quiet;
    QString m_text;
};

} // namespace lds::ui

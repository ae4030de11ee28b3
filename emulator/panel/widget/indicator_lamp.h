#pragma once

#include "display_content.h"

#include <QColor>
#include <QTimer>
#include <QWidget>

namespace lds::emulator {

/// One of the two indicators beside the display (§2.2): off, lit or blinking, with its name.
class IndicatorLamp final : public QWidget {
    Q_OBJECT

public:
    IndicatorLamp(const QString& name, const QColor& color, QWidget* parent = nullptr);

    void showState(IndicatorState state);
    IndicatorState state() const { return m_state; }

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_name;
    QColor m_color;
    QTimer m_blink;
    IndicatorState m_state = IndicatorState::Off;
    bool m_bright = false; ///< Now, while it blinks.
};

} // namespace lds::emulator

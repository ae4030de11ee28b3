#pragma once

#include <QAbstractButton>

namespace lds::emulator {

/// One key of the sensor. Held while the left mouse button or the space bar is down, and between two clicks
/// with the right mouse button, so that several can be held at once.
class KeyButton final : public QAbstractButton {
    Q_OBJECT

public:
    explicit KeyButton(QWidget* parent = nullptr);

    bool isHeld() const { return m_held; }
    bool isLatched() const { return m_latched; }
    void unlatch();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void heldChanged(bool held);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void follow();

    bool m_latched = false;
    bool m_held = false;
};

} // namespace lds::emulator

#pragma once

#include "sensor_session.h"

#include <memory>
#include <QWidget>

namespace lds::ui {

struct ReadoutState;

/// The sensor's own display, always in sight: value in the chosen digits, LASER, HI/GO/LO, HOLD, ZERO,
/// bank, hold-mode letter, KEYLOCK, ----, ±OVER, ALARM (§2.2), received light, rate and losses.
/// Dark in both themes. Dimmed and marked while the value is not live.
class Readout final : public QWidget {
    Q_OBJECT

public:
    explicit Readout(QWidget* parent = nullptr);
    ~Readout() override;
    void setSession(sensor::SensorSession* session);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// What a screen reader says: "+1.2345 mm, GO, laser on, bank 1".
    QString spokenText() const;
    /// What is shown now.
    const ReadoutState& state() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void timerEvent(QTimerEvent* event) override;

private:
    void refresh();
    void refreshSoon();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace lds::ui

#pragma once

#include "sensor_session.h"

#include <QPointer>
#include <QWidget>

namespace lds::ui {

/// The judgment window drawn small: HIGH and LOW as they will be after applying, with the hysteresis
/// inside them, as they are in the sensor where that differs, and the measured value of the last seconds.
class WindowSketch final : public QWidget {
    Q_OBJECT

public:
    explicit WindowSketch(QWidget* parent = nullptr);
    void setSession(sensor::SensorSession* session); ///< nullptr: nothing to draw.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Scale;
    void paintWindow(QPainter& painter, const Scale& scale) const;
    void paintHeld(QPainter& painter, const Scale& scale) const;
    void paintTrace(QPainter& painter, const Scale& scale) const;
    void paintLatest(QPainter& painter, const Scale& scale, catalog::Value value) const;
    QString spokenText(qint64 high, qint64 low) const;

    QPointer<sensor::SensorSession> m_session;
};

} // namespace lds::ui

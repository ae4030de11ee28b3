#pragma once

#include "sensor_session.h"

#include <memory>
#include <QWidget>

namespace lds::ui {

class TrendChart;

/// The measured value over time, live: line with gaps, HIGH and LOW, states, zoom, pan, pause, follow.
/// Each sensor keeps its own view while another one is looked at. Repaints at most 40 times a second, and
/// only while it is seen and something in it has changed.
class TrendPage final : public QWidget {
    Q_OBJECT

public:
    explicit TrendPage(ports::Scheduler& scheduler, QWidget* parent = nullptr);
    ~TrendPage() override;

    void setSession(sensor::SensorSession* session); ///< nullptr: nothing connected.
    TrendChart& chart();

protected:
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace lds::ui

#pragma once

#include "sensor_session.h"

#include <memory>
#include <QWidget>

namespace lds::ui {

/// The measured value over time, live: line with gaps, HIGH and LOW, zoom, pan, pause, follow.
class TrendPage final : public QWidget {
    Q_OBJECT

public:
    explicit TrendPage(ports::Scheduler& scheduler, QWidget* parent = nullptr);
    ~TrendPage() override;

    void setSession(sensor::SensorSession* session); ///< nullptr: nothing connected.

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace lds::ui

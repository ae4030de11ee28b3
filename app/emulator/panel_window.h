#pragma once

#include "front_panel.h"
#include "panel_widget.h"
#include "sensor_station.h"

namespace lds::app {

/// The front panel of a sensor in a window of its own, in the sensor's thread. Closing it leaves the setting
/// mode and the sensor running.
class PanelWindow final : public QWidget {
    Q_OBJECT

public:
    /// As of a sensor whose power has just come on. The station outlives the window.
    explicit PanelWindow(emulator::SensorStation& station);

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    emulator::FrontPanel m_panel;
    emulator::PanelWidget* m_widget;
};

} // namespace lds::app

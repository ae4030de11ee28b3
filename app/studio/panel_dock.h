#pragma once

#include "demo_sensor.h"
#include "panel_widget.h"

#include <QDockWidget>
#include <QPointer>

namespace lds::emulator {
class FrontPanel;
}

namespace lds::app {

/// The front panel of the demo's virtual sensor. The panel itself lives with the sensor, in its thread, from
/// the moment it is ready. Nobody can use the keys of a dock that is not there: closing it leaves the
/// setting mode, so that the sensor takes commands again.
class PanelDock final : public QDockWidget {
    Q_OBJECT

public:
    /// `demo` is ready and outlives the dock.
    explicit PanelDock(emulator::DemoSensor& demo, QWidget* parent = nullptr);

    emulator::PanelWidget& panel() { return *m_widget; }

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void attach(emulator::FrontPanel* panel);

    emulator::PanelWidget* m_widget;
    emulator::FrontPanel* m_panel = nullptr; ///< In the sensor's thread; only to be sent messages.
};

} // namespace lds::app

#include "panel_dock.h"

#include "front_panel.h"

namespace lds::app {

using emulator::DemoSensor;
using emulator::FrontPanel;
using emulator::PanelWidget;
using emulator::SensorStation;

PanelDock::PanelDock(DemoSensor& demo, QWidget* parent)
    : QDockWidget(tr("Sensor front panel"), parent)
    , m_widget(new PanelWidget(this))
{
    setObjectName(QStringLiteral("panelDock"));
    setWidget(m_widget);
    connect(m_widget, &PanelWidget::powerCycleRequested, &demo,
            [&demo] { demo.post([](SensorStation& station) { station.sensor().powerCycle(); }); });
    // The panel is born in the sensor's thread; the demo, which outlives that thread, brings it here.
    demo.post([&demo, dock = QPointer<PanelDock>(this)](SensorStation& station) {
        auto* panel = new FrontPanel(station.sensor(), station.clock(), &station.sensor());
        QMetaObject::invokeMethod(&demo, [dock, panel] {
            if (dock)
                dock->attach(panel);
        });
    });
}

void PanelDock::attach(FrontPanel* panel)
{
    m_panel = panel;
    connect(m_widget, &PanelWidget::keyPressed, panel, &FrontPanel::keyPressed);
    connect(m_widget, &PanelWidget::keyReleased, panel, &FrontPanel::keyReleased);
    connect(panel, &FrontPanel::contentChanged, m_widget, &PanelWidget::showContent);
    QMetaObject::invokeMethod(panel, &FrontPanel::tell);
}

void PanelDock::closeEvent(QCloseEvent* event)
{
    if (m_panel)
        QMetaObject::invokeMethod(m_panel, &FrontPanel::leave);
    QDockWidget::closeEvent(event);
}

} // namespace lds::app

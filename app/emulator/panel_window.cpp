#include "panel_window.h"

#include <QVBoxLayout>

namespace lds::app {

using emulator::FrontPanel;
using emulator::PanelWidget;

PanelWindow::PanelWindow(emulator::SensorStation& station)
    : m_panel(station.sensor(), station.clock())
    , m_widget(new PanelWidget(this))
{
    const auto& model = catalog::Catalog::hlG2().model(station.sensor().model());
    setWindowTitle(QString::fromLatin1(model.typeName));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_widget);
    connect(m_widget, &PanelWidget::keyPressed, &m_panel, &FrontPanel::keyPressed);
    connect(m_widget, &PanelWidget::keyReleased, &m_panel, &FrontPanel::keyReleased);
    connect(m_widget, &PanelWidget::powerCycleRequested, &station.sensor(),
            &emulator::VirtualSensor::powerCycle);
    connect(&m_panel, &FrontPanel::contentChanged, m_widget, &PanelWidget::showContent);
    m_panel.powerOn();
    m_widget->setFocus();
}

void PanelWindow::closeEvent(QCloseEvent* event)
{
    m_panel.leave();
    QWidget::closeEvent(event);
}

} // namespace lds::app

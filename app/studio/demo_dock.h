#pragma once

#include "demo_sensor.h"

#include <QDockWidget>
#include <QList>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace lds::app {

/// What a person can do to the virtual sensor of a demonstration: what it looks at, what goes wrong with
/// it, its trigger input, and its power.
class DemoDock final : public QDockWidget {
    Q_OBJECT

public:
    /// `sensor` must outlive it.
    explicit DemoDock(emulator::DemoSensor& sensor, QWidget* parent = nullptr);

private:
    void addScenes(QVBoxLayout& column);
    void addWorkpieces(QVBoxLayout& column);
    void addFaults(QVBoxLayout& column);
    void addButtons(QVBoxLayout& column);
    void chooseFile();
    void holdChosenWorkpiece(int index);
    void showState(const emulator::StationState& state);
    void showScene(const emulator::StationState& state);
    void showWorkpieces(const emulator::StationState& state);
    void showFault(QCheckBox& box, const emulator::StationState::Fault& fault);
    void showError(const QString& reason);

    emulator::DemoSensor& m_sensor;
    QComboBox* m_scenes;
    QPushButton* m_open;
    QLabel* m_error;
    QComboBox* m_workpieces;
    QList<QCheckBox*> m_faults; ///< In the order of allFaults().
    QPushButton* m_trigger;
    QPushButton* m_powerCycle;
};

} // namespace lds::app

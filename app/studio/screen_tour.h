#pragma once

#include "demo_sensor.h"
#include "main_window.h"

#include <functional>
#include <QDir>
#include <QList>

namespace lds::app {

/// Leads the window through its main screens on the demo sensor and renders each into a PNG file.
class ScreenTour final : public QObject {
    Q_OBJECT

public:
    ScreenTour(ui::MainWindow& window, sensor::Workspace& workspace, emulator::DemoSensor& demo,
               ports::Scheduler& scheduler, const QDir& folder);
    void start();

Q_SIGNALS:
    void rendered(const QString& file);
    void finished();
    void failed(const QString& reason);

private:
    struct Stop {
        QString name; ///< Of the file, without number and ending; empty: nothing is rendered.
        std::function<void()> prepare;
        std::function<bool()> isReady; ///< Looked at again and again until true.
    };

    void planStops();
    void planDialogs();
    void planThemes();
    void next();
    void lookAgain(int triesLeft);
    void render(const QString& name);
    sensor::SensorSession* session() const { return m_workspace.current(); }
    bool edit();
    void setLook(ui::MainWindow::Page page, const QSize& size, bool dark);

    ui::MainWindow& m_window;
    sensor::Workspace& m_workspace;
    emulator::DemoSensor& m_demo;
    ports::Scheduler& m_scheduler;
    QDir m_folder;
    QList<Stop> m_stops;
    int m_current = -1;
    int m_pictures = 0;
};

} // namespace lds::app

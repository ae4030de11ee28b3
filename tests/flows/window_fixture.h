#pragma once

#include "demo_sensor.h"
#include "main_window.h"
#include "modbus_link_factory.h"
#include "qt_scheduler.h"
#include "theme.h"

#include <memory>
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

namespace lds::flows {

using catalog::ItemId;
using catalog::Value;
using emulator::SensorStation;

/// The real window on real links, and a virtual sensor on a real socket; what a person does goes through
/// mouse and keys.
class WindowFixture {
public:
    explicit WindowFixture(catalog::SensorModel model = catalog::SensorModel::HlG203)
        : device(std::make_unique<emulator::DemoSensor>(model))
        , settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat)
        , window(std::make_unique<ui::MainWindow>(workspace, log, scheduler, settings))
    {
        device->start();
        window->resize(1280, 800);
        window->show();
        activate();
    }
    /// Offscreen nobody gives the focus back when a dialog closes, as a window manager would.
    void activate()
    {
        window->activateWindow();
        if (!QTest::qWaitForWindowActive(window.get()))
            qFatal("the window does not become active");
    }
    ~WindowFixture()
    {
        window.reset();
        for (auto* session : QList(workspace.sessions()))
            workspace.remove(session);
    }
    WindowFixture(const WindowFixture&) = delete;
    WindowFixture& operator=(const WindowFixture&) = delete;

    sensor::SensorSession* session() const { return workspace.current(); }

    /// What the virtual sensor holds.
    Value holds(ItemId item)
    {
        return device->ask([item](SensorStation& station) { return station.sensor().memory().value(item); });
    }
    Value hasSaved(ItemId item)
    {
        return device->ask(
            [item](SensorStation& station) { return station.sensor().savedMemory().value(item); });
    }
    int writesOf(ItemId item)
    {
        return device->ask([item](SensorStation& station) { return station.sensor().writeCount(item); });
    }

    template <typename Widget>
    Widget* find(const char* name, QWidget* in = nullptr) const
    {
        return (in ? in : window.get())->template findChild<Widget*>(QLatin1StringView(name));
    }
    QAction* action(const char* name) const { return window->findChild<QAction*>(QLatin1StringView(name)); }

    static void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
    static void type(QWidget* widget, const QString& text)
    {
        widget->setFocus();
        if (auto* line = qobject_cast<QLineEdit*>(widget))
            line->selectAll();
        QTest::keyClicks(widget, text);
    }

    QTemporaryDir folder;
    std::unique_ptr<emulator::DemoSensor> device;
    ui::MessageLog log;
    ports::QtScheduler scheduler;
    modbus::ModbusLinkFactory links{log};
    sensor::Workspace workspace{links, scheduler};
    QSettings settings;
    std::unique_ptr<ui::MainWindow> window;
};

} // namespace lds::flows

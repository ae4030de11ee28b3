// lds-studio: the desktop tool.

#include "demo_dock.h"
#include "demo_sensor.h"
#include "main_window.h"
#include "modbus_link_factory.h"
#include "modbus_scan_factory.h"
#include "panel_dock.h"
#include "qt_scheduler.h"
#include "qt_serial_ports.h"
#include "screen_tour.h"
#include "studio_options.h"

#include <cstdio>
#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

namespace {

using namespace lds;
using namespace Qt::StringLiterals;
using app::StudioOptions;
using emulator::DemoSensor;

enum ExitCode { Done = 0, Failed = 1, WrongUsage = 2 };

void print(std::FILE* stream, const QString& text)
{
    const QByteArray bytes = text.toLocal8Bit();
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stream);
    std::fflush(stream);
}

int fail(const QString& message, ExitCode code)
{
    print(stderr, u"lds-studio: %1\n"_s.arg(message));
    return code;
}

/// Before there is an application, so that help and wrong usage need no display. Qt's own "-platform" is
/// left to Qt.
QStringList argumentsOf(int argc, char* argv[])
{
    QStringList arguments;
    for (int index = 0; index < argc; ++index) {
        const QString argument = QString::fromLocal8Bit(argv[index]);
        if (argument == u"-platform")
            ++index;
        else
            arguments += argument;
    }
    return arguments;
}

bool hasDisplay()
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

/// Starts the virtual sensor, once, and connects to it when it listens.
class Demo final : public QObject {
public:
    Demo(sensor::Workspace& workspace, catalog::SensorModel model)
        : m_sensor(model)
    {
        connect(&m_sensor, &DemoSensor::ready, this, [this, &workspace](quint16 port) {
            ports::ConnectionUrl url;
            url.host = u"127.0.0.1"_s;
            url.port = port;
            url.sensor = m_sensor.model();
            workspace.add(url, QCoreApplication::translate("Demo", "Virtual sensor"))->open();
        });
    }
    DemoSensor& sensor() { return m_sensor; }

private:
    DemoSensor m_sensor;
};

QString storedThemeKey() { return u"view/theme"_s; }

ui::ThemeMode themeFor(const StudioOptions& options, const QSettings& settings)
{
    if (options.theme)
        return *options.theme;
    const int stored = settings.value(storedThemeKey(), int(ui::ThemeMode::System)).toInt();
    return ui::ThemeMode(qBound(int(ui::ThemeMode::System), stored, int(ui::ThemeMode::Dark)));
}

int run(QApplication& application, const StudioOptions& options, QSettings& settings)
{
    ui::MessageLog log;
    ports::QtScheduler scheduler;
    modbus::ModbusLinkFactory links(log);
    const modbus::QtSerialPorts serialPorts;
    modbus::ModbusScanFactory scans(links.buses(), links.thread());
    sensor::Workspace workspace(links, scheduler);
    Demo demo(workspace, options.demo.value_or(catalog::SensorModel::HlG203));
    ui::Theme::instance().apply(application, themeFor(options, settings));
    ui::MainWindow window(workspace, log, scheduler, settings);

    QObject::connect(&demo.sensor(), &DemoSensor::failed, &application, [](const QString& reason) {
        QCoreApplication::exit(fail(u"The virtual sensor cannot start: %1"_s.arg(reason), Failed));
    });
    QObject::connect(&window, &ui::MainWindow::demoRequested, &demo.sensor(), &DemoSensor::start);
    QObject::connect(&demo.sensor(), &DemoSensor::ready, &window, [&] {
        window.addDock(new app::DemoDock(demo.sensor(), &window));
        window.addDock(new app::PanelDock(demo.sensor(), &window));
    });
    window.setSerial(serialPorts, scans, links);
    window.offerDemo();
    if (options.demo)
        demo.sensor().start();
    for (const auto& url : options.connections)
        workspace.add(url)->open();

    std::unique_ptr<app::ScreenTour> tour;
    if (!options.tourFolder.isEmpty()) {
        tour = std::make_unique<app::ScreenTour>(window, workspace, demo.sensor(), scheduler,
                                                 QDir(options.tourFolder));
        QObject::connect(tour.get(), &app::ScreenTour::rendered, &application,
                         [](const QString& file) { print(stdout, file + u'\n'); });
        QObject::connect(tour.get(), &app::ScreenTour::finished, &application,
                         [] { QCoreApplication::exit(Done); });
        QObject::connect(tour.get(), &app::ScreenTour::failed, &application,
                         [](const QString& reason) { QCoreApplication::exit(fail(reason, Failed)); });
        QMetaObject::invokeMethod(tour.get(), &app::ScreenTour::start, Qt::QueuedConnection);
    }
    window.show();
    return QApplication::exec();
}

} // namespace

int main(int argc, char* argv[])
{
    const auto options = app::parseStudioOptions(argumentsOf(argc, argv));
    if (!options)
        return fail(options.error(), WrongUsage);
    if (!options->information.isEmpty()) {
        print(stdout, options->information);
        return Done;
    }
    const bool isTour = !options->tourFolder.isEmpty();
    if (isTour && !QDir().mkpath(options->tourFolder))
        return fail(u"The folder %1 cannot be made. Choose another."_s.arg(options->tourFolder), Failed);
    if (isTour && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    if (!hasDisplay())
        return fail(u"There is no display. Use --tour DIR to render the screens into files."_s, Failed);

    QApplication application(argc, argv);
    QApplication::setApplicationName(u"lds-studio"_s);
    QApplication::setOrganizationName(u"lds-studio"_s);
    QApplication::setApplicationDisplayName(u"LDS Studio"_s);
    QApplication::setApplicationVersion(QStringLiteral(LDS_VERSION));
    QApplication::setDesktopFileName(u"lds-studio"_s);
    ports::registerMetaTypes();

    if (isTour) { // must look the same on every machine and leave nothing behind
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(u"tour.ini"_s), QSettings::IniFormat);
        return run(application, *options, settings);
    }
    QSettings settings;
    return run(application, *options, settings);
}

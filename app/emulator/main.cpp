// lds-emulator: virtual sensors that speak the real protocols on real sockets and serial lines.

#include "control_desk.h"
#include "control_input.h"
#include "control_socket.h"
#include "emulator_options.h"
#include "panel_window.h"
#include "rtu_lines.h"
#include "system_clock.h"
#include "unix_signals.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <QApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <vector>

namespace {

using namespace lds;
using namespace Qt::StringLiterals;
using emulator::SensorStation;
using emulator::StationProblem;

enum ExitCode { Done = 0, CannotServe = 1, WrongUsage = 2 };

void print(std::FILE* stream, const QByteArray& bytes)
{
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stream);
    std::fflush(stream);
}

void log(const QString& message) { print(stderr, u"lds-emulator: %1\n"_s.arg(message).toUtf8()); }

int fail(const QString& message, ExitCode code)
{
    log(message);
    return code;
}

QJsonValue portValue(std::optional<quint16> port) { return port ? QJsonValue(*port) : QJsonValue(); }

/// One sensor as the ready line shows it; servers of later versions are null.
QJsonObject describe(SensorStation& station, const QString& rtu)
{
    const auto& model = catalog::Catalog::hlG2().model(station.sensor().model());
    return QJsonObject{{u"ready"_s, true},
                       {u"sensor"_s, QString::fromLatin1(model.typeName)},
                       {u"modbusPort"_s, portValue(station.modbusPort())},
                       {u"toolPort"_s, portValue(station.toolPort())},
                       {u"slmpPort"_s, QJsonValue()},
                       {u"eipPort"_s, QJsonValue()},
                       {u"rtu"_s, rtu.isEmpty() ? QJsonValue() : QJsonValue(rtu)}};
}

/// The running program: its stations, and whoever controls them.
class Emulator {
public:
    explicit Emulator(const app::EmulatorOptions& options)
        : m_options(options)
    {}

    /// Done, or the exit code after it has said why not. Nothing listens before all files are read.
    ExitCode start()
    {
        for (const auto& options : m_options.stations) {
            auto station = SensorStation::prepare(options, m_clock);
            if (!station)
                return complain(m_stations.size(), station.error());
            m_stations.push_back(std::move(*station));
        }
        for (std::size_t i = 0; i < m_stations.size(); ++i) {
            if (const auto listening = m_stations[i]->listen(); !listening)
                return complain(i, listening.error());
            if (const auto attached = attach(i); !attached)
                return complain(i, {StationProblem::Kind::Listen, attached.error()});
            watch(i);
        }
        return startControl();
    }

    /// §2.2; needs a QApplication.
    void showPanel()
    {
        m_panel = std::make_unique<app::PanelWindow>(*m_stations.front());
        m_panel->show();
    }

    QJsonObject readyLine() const
    {
        QJsonArray sensors;
        for (std::size_t i = 0; i < m_stations.size(); ++i)
            sensors.append(describe(*m_stations[i], m_links[qsizetype(i)]));
        QJsonObject ready = m_options.fromConfig ? QJsonObject{{u"ready"_s, true}, {u"sensors"_s, sensors}}
                                                 : sensors.first().toObject();
        if (m_options.control)
            ready.insert(u"control"_s, true);
        if (m_socket)
            ready.insert(u"controlSocket"_s, m_socket->path());
        return ready;
    }

private:
    /// To its RS-485 line, if it is to have one.
    tl::expected<void, QString> attach(std::size_t index)
    {
        const QString& link = m_options.stations.at(qsizetype(index)).rtuLink;
        m_links.append(QString());
        if (link.isEmpty())
            return {};
        const auto attached = m_lines.attach(m_stations[index]->rtuUnit(), link);
        if (!attached)
            return tl::unexpected(u"cannot serve Modbus RTU at "_s + attached.error());
        m_links.last() = *attached;
        return {};
    }

    QString named(std::size_t index, const QString& message) const
    {
        return m_options.fromConfig ? u"sensors[%1]: %2"_s.arg(index).arg(message) : message;
    }

    ExitCode complain(std::size_t index, const StationProblem& problem) const
    {
        log(named(index, problem.message));
        return problem.kind == StationProblem::Kind::Listen ? CannotServe : WrongUsage;
    }

    void watch(std::size_t index)
    {
        SensorStation& station = *m_stations[index];
        QObject::connect(
            &station.sensor(), &emulator::VirtualSensor::storeFailed, &station,
            [this, index](const QString& reason) { log(named(index, u"cannot save: "_s + reason)); });
        QObject::connect(&station, &SensorStation::networkChanged, &station,
                         [this, index](const QString& message) { log(named(index, message)); });
    }

    ExitCode startControl()
    {
        QList<SensorStation*> stations;
        for (const auto& station : m_stations)
            stations.append(station.get());
        m_desk = std::make_unique<app::ControlDesk>(stations);
        if (m_options.control)
            m_input = std::make_unique<app::ControlInput>(
                *m_desk, fileno(stdin), [](const QByteArray& line) { print(stdout, line); });
        if (m_options.controlSocket.isEmpty())
            return Done;
        m_socket = std::make_unique<app::ControlSocket>(*m_desk);
        const auto listening = m_socket->listen(m_options.controlSocket);
        return listening ? Done : ExitCode(fail(u"--control-socket "_s + listening.error(), CannotServe));
    }

    const app::EmulatorOptions& m_options;
    emulator::SystemClock m_clock;
    app::RtuLines m_lines{m_clock};
    std::vector<std::unique_ptr<SensorStation>> m_stations;
    QStringList m_links; ///< Of each station's line; empty: none.
    std::unique_ptr<app::PanelWindow> m_panel;
    std::unique_ptr<app::ControlDesk> m_desk;
    std::unique_ptr<app::ControlInput> m_input;
    std::unique_ptr<app::ControlSocket> m_socket;
};

bool hasDisplay()
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

/// With windows only where one is asked for and possible: else the emulator needs no display.
std::unique_ptr<QCoreApplication> makeApplication(int& argc, char* argv[])
{
    const bool wantsWindow = std::any_of(
        argv, argv + argc, [](const char* argument) { return QByteArrayView(argument) == "--panel"; });
    if (!wantsWindow || !hasDisplay())
        return std::make_unique<QCoreApplication>(argc, argv);
    auto application = std::make_unique<QApplication>(argc, argv);
    QGuiApplication::setQuitOnLastWindowClosed(false); // the sensor stays until a signal
    return application;
}

} // namespace

int main(int argc, char* argv[])
{
    const auto application = makeApplication(argc, argv);
    const auto options = app::parseCommandLine(QCoreApplication::arguments());
    if (!options)
        return fail(options.error(), WrongUsage);
    if (!options->information.isEmpty()) {
        print(stdout, options->information.toUtf8());
        return Done;
    }

    if (options->panel && !qobject_cast<QApplication*>(application.get()))
        return fail(u"--panel: there is no display to show it on"_s, CannotServe);

    const app::UnixSignals signalsToQuit([] { QCoreApplication::quit(); });
    Emulator emulator(*options);
    if (const ExitCode started = emulator.start(); started != Done)
        return started;
    if (options->panel)
        emulator.showPanel();
    print(stdout, QJsonDocument(emulator.readyLine()).toJson(QJsonDocument::Compact) + '\n');
    return QCoreApplication::exec();
}

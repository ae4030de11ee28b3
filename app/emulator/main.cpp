// lds-emulator: virtual sensors that speak the real protocols on real sockets.

#include "emulator_options.h"
#include "system_clock.h"
#include "unix_signals.h"

#include <cstdio>
#include <memory>
#include <QCoreApplication>
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

void print(std::FILE* stream, const QString& text)
{
    const QByteArray bytes = text.toUtf8();
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stream);
    std::fflush(stream);
}

int fail(const QString& message, ExitCode code)
{
    print(stderr, u"lds-emulator: %1\n"_s.arg(message));
    return code;
}

QJsonValue portValue(std::optional<quint16> port) { return port ? QJsonValue(*port) : QJsonValue(); }

/// One sensor as the ready line shows it; servers of later versions are null.
QJsonObject describe(SensorStation& station)
{
    const auto& model = catalog::Catalog::hlG2().model(station.sensor().model());
    return QJsonObject{{u"ready"_s, true},
                       {u"sensor"_s, QString::fromLatin1(model.typeName)},
                       {u"modbusPort"_s, portValue(station.modbusPort())},
                       {u"toolPort"_s, portValue(station.toolPort())},
                       {u"slmpPort"_s, QJsonValue()},
                       {u"eipPort"_s, QJsonValue()},
                       {u"rtu"_s, QJsonValue()}};
}

} // namespace

int main(int argc, char* argv[])
{
    QCoreApplication application(argc, argv);
    const auto options = app::parseCommandLine(QCoreApplication::arguments());
    if (!options)
        return fail(options.error(), WrongUsage);
    if (!options->information.isEmpty()) {
        print(stdout, options->information);
        return Done;
    }

    const app::UnixSignals signalsToQuit([] { QCoreApplication::quit(); });
    emulator::SystemClock clock;
    std::vector<std::unique_ptr<SensorStation>> stations;
    QJsonArray sensors;
    for (const auto& stationOptions : options->stations) {
        auto station = SensorStation::start(stationOptions, clock);
        if (!station) {
            const bool state = station.error().kind == StationProblem::Kind::StateFile;
            return fail(station.error().message, state ? WrongUsage : CannotServe);
        }
        QObject::connect(&(*station)->sensor(), &emulator::VirtualSensor::storeFailed, &application,
                         [](const QString& reason) { fail(u"cannot save: "_s + reason, CannotServe); });
        sensors.append(describe(**station));
        stations.push_back(std::move(*station));
    }
    const QJsonObject ready = options->fromConfig ? QJsonObject{{u"ready"_s, true}, {u"sensors"_s, sensors}}
                                                  : sensors.first().toObject();
    print(stdout, QString::fromUtf8(QJsonDocument(ready).toJson(QJsonDocument::Compact)) + u'\n');
    return QCoreApplication::exec();
}

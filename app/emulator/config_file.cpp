#include "emulator_options.h"

#include <cmath>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace lds::app {

using namespace Qt::StringLiterals;
using emulator::StationOptions;

namespace {

constexpr qint64 largestFile = 1024 * 1024;
const QStringList knownKeys{u"sensor"_s,          u"bind"_s,  u"modbusPort"_s,
                            u"toolPort"_s,        u"rtu"_s,   u"unit"_s,
                            u"answeringTimeMs"_s, u"state"_s, u"scene"_s};
const QStringList laterKeys{u"slmpPort"_s, u"eipPort"_s, u"eipIoPort"_s};

constexpr int longestAnsweringMs = 60'000;

/// Nothing for null and for what is not there.
tl::expected<std::optional<int>, QString> numberOf(const QJsonObject& object, const QString& key,
                                                   const QString& where, const QString& what, int from,
                                                   int to)
{
    const QJsonValue value = object.value(key);
    if (value.isUndefined() || value.isNull())
        return std::nullopt;
    const double number = value.toDouble(-1);
    if (number < from || number > to || number != std::floor(number)) {
        return tl::unexpected(
            u"%1.%2: has to be %3 from %4 to %5, or null"_s.arg(where, key, what).arg(from).arg(to));
    }
    return std::optional(int(number));
}

tl::expected<std::optional<quint16>, QString> portOf(const QJsonObject& object, const QString& key,
                                                     const QString& where)
{
    const auto port = numberOf(object, key, where, u"a port"_s, 0, 0xffff);
    if (!port)
        return tl::unexpected(port.error());
    return *port ? std::optional(quint16(**port)) : std::nullopt;
}

tl::expected<QString, QString> textOf(const QJsonObject& object, const QString& key, const QString& where,
                                      const QString& otherwise)
{
    const QJsonValue value = object.value(key);
    if (value.isUndefined())
        return otherwise;
    if (!value.isString() || value.toString().isEmpty())
        return tl::unexpected(u"%1.%2: has to be a text"_s.arg(where, key));
    return value.toString();
}

tl::expected<void, QString> checkKeys(const QJsonObject& object, const QString& where)
{
    const QStringList keys = object.keys();
    for (const QString& key : keys) {
        if (laterKeys.contains(key))
            return tl::unexpected(
                u"%1.%2: is not in this version, which speaks Modbus TCP and RTU only"_s.arg(where, key));
        if (!knownKeys.contains(key))
            return tl::unexpected(u"%1.%2: is not a field of a sensor; these are: %3"_s.arg(
                where, key, knownKeys.join(u", "_s)));
    }
    return {};
}

/// An example's key stays what it is; a file is looked for beside the configuration file.
QString sceneOf(const QString& text, const QDir& folder)
{
    if (text.isEmpty() || emulator::Scene::examples().contains(text))
        return text;
    return QDir::cleanPath(folder.absoluteFilePath(text));
}

/// Its place on an RS-485 line, into `station`.
tl::expected<void, QString> readLine(const QJsonObject& object, const QString& where, const QDir& folder,
                                     StationOptions& station)
{
    const auto link = textOf(object, u"rtu"_s, where, {});
    if (!link)
        return tl::unexpected(link.error());
    const auto unit =
        numberOf(object, u"unit"_s, where, u"a device address"_s, modbus::firstRtuUnit, modbus::lastRtuUnit);
    if (!unit)
        return tl::unexpected(unit.error());
    const auto answering =
        numberOf(object, u"answeringTimeMs"_s, where, u"a number"_s, 0, longestAnsweringMs);
    if (!answering)
        return tl::unexpected(answering.error());
    if (link->isEmpty()) {
        if (*unit || *answering)
            return tl::unexpected(
                u"%1: unit and answeringTimeMs belong to rtu, the link of a line"_s.arg(where));
        return {};
    }
    station.rtuLink = QDir::cleanPath(folder.absoluteFilePath(*link));
    if (*unit)
        station.unit = quint8(**unit);
    station.answeringTimeMs = answering->value_or(0);
    return {};
}

tl::expected<StationOptions, QString> stationOf(const QJsonValue& value, const QString& where,
                                                const QDir& folder)
{
    if (!value.isObject())
        return tl::unexpected(u"%1: has to be an object"_s.arg(where));
    const QJsonObject object = value.toObject();
    if (const auto checked = checkKeys(object, where); !checked)
        return tl::unexpected(checked.error());
    const auto type = textOf(object, u"sensor"_s, where, {});
    if (!type)
        return tl::unexpected(type.error());
    const auto model = modelNamed(*type);
    if (!model)
        return tl::unexpected(u"%1.sensor: %2"_s.arg(where, model.error()));
    const auto bind = textOf(object, u"bind"_s, where, u"127.0.0.1"_s);
    if (!bind)
        return tl::unexpected(bind.error());
    const auto address = bindAddress(*bind);
    if (!address)
        return tl::unexpected(u"%1.bind: %2"_s.arg(where, address.error()));
    const auto modbusPort = portOf(object, u"modbusPort"_s, where);
    if (!modbusPort)
        return tl::unexpected(modbusPort.error());
    const auto toolPort = portOf(object, u"toolPort"_s, where);
    if (!toolPort)
        return tl::unexpected(toolPort.error());
    StationOptions station;
    if (const auto read = readLine(object, where, folder, station); !read)
        return tl::unexpected(read.error());
    if (!*modbusPort && !*toolPort && station.rtuLink.isEmpty())
        return tl::unexpected(u"%1: nothing to serve: give modbusPort, toolPort or rtu"_s.arg(where));
    const auto state = textOf(object, u"state"_s, where, {});
    if (!state)
        return tl::unexpected(state.error());
    const QString stateFile = state->isEmpty() ? QString() : QDir::cleanPath(folder.absoluteFilePath(*state));
    const auto scene = textOf(object, u"scene"_s, where, {});
    if (!scene)
        return tl::unexpected(scene.error());
    station.model = *model;
    station.address = *address;
    station.modbusPort = *modbusPort;
    station.toolPort = *toolPort;
    station.stateFile = stateFile;
    station.scene = sceneOf(*scene, folder);
    return station;
}

tl::expected<QList<StationOptions>, QString> stationsOf(const QByteArray& json, const QDir& folder)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError)
        return tl::unexpected(u"is not JSON: %1 at byte %2"_s.arg(error.errorString()).arg(error.offset));
    const QJsonObject root = document.object();
    const QJsonArray list = root.value("sensors"_L1).toArray();
    if (list.isEmpty() || root.size() != 1)
        return tl::unexpected(u"has to be {\"sensors\": [...]} with at least one sensor and nothing else"_s);
    QList<StationOptions> stations;
    for (qsizetype i = 0; i < list.size(); ++i) {
        const auto station = stationOf(list.at(i), u"sensors[%1]"_s.arg(i), folder);
        if (!station)
            return tl::unexpected(station.error());
        for (const StationOptions& other : std::as_const(stations)) {
            if (!station->stateFile.isEmpty() && other.stateFile == station->stateFile)
                return tl::unexpected(u"sensors[%1].state: another sensor has this file"_s.arg(i));
        }
        stations.append(*station);
    }
    return stations;
}

} // namespace

tl::expected<QList<StationOptions>, QString> readConfigFile(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(u"%1: %2"_s.arg(path, file.errorString()));
    const QByteArray json = file.read(largestFile + 1);
    if (json.size() > largestFile)
        return tl::unexpected(u"%1: is larger than %2 bytes"_s.arg(path).arg(largestFile));
    auto stations = stationsOf(json, QFileInfo(path).absoluteDir());
    if (!stations)
        return tl::unexpected(u"%1: %2"_s.arg(path, stations.error()));
    return stations;
}

} // namespace lds::app

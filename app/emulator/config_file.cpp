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
const QStringList knownKeys{u"sensor"_s, u"bind"_s, u"modbusPort"_s, u"toolPort"_s, u"state"_s, u"scene"_s};
const QStringList laterKeys{u"slmpPort"_s, u"eipPort"_s, u"eipIoPort"_s, u"rtu"_s, u"unit"_s};

tl::expected<std::optional<quint16>, QString> portOf(const QJsonValue& value, const QString& field)
{
    if (value.isUndefined() || value.isNull())
        return std::nullopt;
    const double number = value.toDouble(-1);
    if (number < 0 || number > 0xffff || number != std::floor(number))
        return tl::unexpected(u"%1: has to be a port from 0 to 65535, or null"_s.arg(field));
    return std::optional(quint16(number));
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
                u"%1.%2: is not in this version, which speaks Modbus TCP only"_s.arg(where, key));
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
    const auto modbusPort = portOf(object.value("modbusPort"_L1), where + u".modbusPort"_s);
    if (!modbusPort)
        return tl::unexpected(modbusPort.error());
    const auto toolPort = portOf(object.value("toolPort"_L1), where + u".toolPort"_s);
    if (!toolPort)
        return tl::unexpected(toolPort.error());
    if (!*modbusPort && !*toolPort)
        return tl::unexpected(u"%1: nothing to serve: give modbusPort or toolPort"_s.arg(where));
    const auto state = textOf(object, u"state"_s, where, {});
    if (!state)
        return tl::unexpected(state.error());
    const QString stateFile = state->isEmpty() ? QString() : QDir::cleanPath(folder.absoluteFilePath(*state));
    const auto scene = textOf(object, u"scene"_s, where, {});
    if (!scene)
        return tl::unexpected(scene.error());
    StationOptions station;
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

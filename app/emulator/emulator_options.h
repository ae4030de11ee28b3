#pragma once

#include "sensor_station.h"

#include <QList>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

namespace lds::app {

/// What the command line or a configuration file asks of the emulator.
struct EmulatorOptions {
    QList<emulator::StationOptions> stations;
    bool fromConfig = false; ///< The ready line then has a list of sensors.
    bool control = false;    ///< Take control lines from standard input.
    QString controlSocket;   ///< Take them from a local socket of this name too; empty: no.
    bool panel = false;      ///< Show the front panel of the first sensor in a window.
    QString information;     ///< Text to print and leave with success: help, version, scenes.
};

/// What is wrong with it, for standard error.
tl::expected<EmulatorOptions, QString> parseCommandLine(const QStringList& arguments);

/// A configuration file (--config): several sensors in one JSON file,
///
///     { "sensors": [ { "sensor": "HL-G203B-S-MK", "bind": "127.0.0.1",
///                      "modbusPort": 15020, "toolPort": 0, "state": "first.json",
///                      "rtu": "line", "unit": 17, "answeringTimeMs": 2,
///                      "scene": "conveyor-step" }, … ] }
///
/// "sensor" and at least one port or "rtu" are needed; port 0 picks a free one, null or nothing starts no
/// such server; "bind" is 127.0.0.1 unless told; sensors with the same "rtu" share that line; a relative
/// "state", "rtu" or scene file is looked for beside the configuration file.
tl::expected<QList<emulator::StationOptions>, QString> readConfigFile(const QString& path);

/// The model of a type name, or a message that lists the known ones.
tl::expected<catalog::SensorModel, QString> modelNamed(const QString& typeName);
/// An IP address to listen on, never a name.
tl::expected<QHostAddress, QString> bindAddress(const QString& text);

} // namespace lds::app

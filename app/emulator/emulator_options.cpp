#include "emulator_options.h"

#include "control_input.h"

#include <QCommandLineParser>

namespace lds::app {

using namespace Qt::StringLiterals;
using emulator::StationOptions;

namespace {

/// Options of the contract that this version knows and cannot do yet.
const QStringList laterOptions{u"slmp-port"_s, u"eip-port"_s, u"eip-io-port"_s};
const QStringList sensorOptions{u"bind"_s, u"modbus-port"_s, u"tool-port"_s, u"rtu"_s,
                                u"unit"_s, u"state"_s,       u"scene"_s};

void declareOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(u"Virtual HL-G2 displacement sensors that speak Modbus TCP and RTU."_s);
    parser.addOptions({
        {u"sensor"_s, u"Type of the sensor, for example HL-G203B-S-MK."_s, u"TYPE"_s},
        {u"bind"_s, u"Address to listen on; 127.0.0.1 unless told."_s, u"ADDRESS"_s, u"127.0.0.1"_s},
        {u"modbus-port"_s, u"Port of the Modbus TCP server; 0 picks a free one."_s, u"PORT"_s},
        {u"tool-port"_s, u"Port for configuration tools, Modbus TCP as well; 0 picks a free one."_s,
         u"PORT"_s},
        {u"rtu"_s,
         u"Serve Modbus RTU on a pseudo-terminal, to which this link is made; programs open it like a serial "
         "port."_s,
         u"LINK"_s},
        {u"unit"_s,
         u"Device address on that line, 1 to 247, until it is changed; the saved one unless told."_s, u"N"_s},
        {u"state"_s, u"File that keeps the saved settings; made at the first saving."_s, u"FILE"_s},
        {u"scene"_s,
         u"What the sensor looks at: a scene file, or an example of --list-scenes. Without it a workpiece "
         "moves gently."_s,
         u"SCENE"_s},
        {u"config"_s,
         u"JSON file with several sensors: {\"sensors\": [{\"sensor\", \"bind\", \"modbusPort\", "
         "\"toolPort\", \"rtu\", \"unit\", \"answeringTimeMs\", \"state\", \"scene\"}, ...]}."_s,
         u"FILE"_s},
        {u"control"_s, u"Take control lines from standard input; type help and Enter."_s},
        {u"control-socket"_s, u"Take control lines from a local socket."_s, u"NAME"_s},
        {u"panel"_s, u"Show the front panel of the sensor, of --config the first one, in a window."_s},
        {u"list-scenes"_s, u"Print the example scenes and leave."_s},
    });
    for (const QString& name : laterOptions) {
        QCommandLineOption option(name, u"Not in this version."_s, u"VALUE"_s);
        option.setFlags(QCommandLineOption::HiddenFromHelp);
        parser.addOption(option);
    }
    parser.addHelpOption();
    parser.addVersionOption();
}

tl::expected<std::optional<quint16>, QString> portOption(const QCommandLineParser& parser,
                                                         const QString& name)
{
    if (!parser.isSet(name))
        return std::nullopt;
    bool isNumber = false;
    const int port = parser.value(name).toInt(&isNumber);
    if (!isNumber || port < 0 || port > 0xffff) {
        return tl::unexpected(u"--%1 %2: a port is a number from 0 to 65535, 0 for any free one"_s.arg(
            name, parser.value(name)));
    }
    return std::optional(quint16(port));
}

tl::expected<std::optional<quint8>, QString> unitOption(const QCommandLineParser& parser)
{
    if (!parser.isSet(u"unit"_s))
        return std::nullopt;
    if (!parser.isSet(u"rtu"_s))
        return tl::unexpected(u"--unit: is an address on a line; give --rtu LINK too"_s);
    bool isNumber = false;
    const int unit = parser.value(u"unit"_s).toInt(&isNumber);
    if (!isNumber || unit < modbus::firstRtuUnit || unit > modbus::lastRtuUnit) {
        return tl::unexpected(
            u"--unit %1: a device address is a number from 1 to 247"_s.arg(parser.value(u"unit"_s)));
    }
    return std::optional(quint8(unit));
}

/// A file or scene that is named has to have a name.
tl::expected<void, QString> checkNames(const QCommandLineParser& parser)
{
    for (const QString& name : {u"rtu"_s, u"state"_s, u"scene"_s}) {
        if (parser.isSet(name) && parser.value(name).isEmpty())
            return tl::unexpected(u"--%1: the name is empty"_s.arg(name));
    }
    return {};
}

tl::expected<StationOptions, QString> stationOf(const QCommandLineParser& parser)
{
    const auto model = modelNamed(parser.value(u"sensor"_s));
    if (!model)
        return tl::unexpected(u"--sensor: "_s + model.error());
    const auto address = bindAddress(parser.value(u"bind"_s));
    if (!address)
        return tl::unexpected(u"--bind: "_s + address.error());
    const auto modbusPort = portOption(parser, u"modbus-port"_s);
    if (!modbusPort)
        return tl::unexpected(modbusPort.error());
    const auto toolPort = portOption(parser, u"tool-port"_s);
    if (!toolPort)
        return tl::unexpected(toolPort.error());
    const auto unit = unitOption(parser);
    if (!unit)
        return tl::unexpected(unit.error());
    if (const auto checked = checkNames(parser); !checked)
        return tl::unexpected(checked.error());
    if (!*modbusPort && !*toolPort && !parser.isSet(u"rtu"_s)) {
        return tl::unexpected(
            u"nothing to serve: give --modbus-port or --tool-port, 0 for any free port, or --rtu LINK"_s);
    }
    StationOptions station;
    station.model = *model;
    station.address = *address;
    station.modbusPort = *modbusPort;
    station.toolPort = *toolPort;
    station.rtuLink = parser.value(u"rtu"_s);
    station.unit = *unit;
    station.stateFile = parser.value(u"state"_s);
    station.scene = parser.value(u"scene"_s);
    return station;
}

QString sceneList()
{
    QString list;
    for (const QString& key : emulator::Scene::examples()) {
        const auto scene = emulator::Scene::load(key, catalog::SensorModel::HlG203);
        list += u"%1  %2\n"_s.arg(key.leftJustified(20), scene ? (*scene)->name() : scene.error());
    }
    return list;
}

/// What leaves the program at once; empty when nothing does.
QString informationFor(const QCommandLineParser& parser)
{
    if (parser.isSet(u"help"_s) || parser.isSet(u"help-all"_s))
        return parser.helpText();
    if (parser.isSet(u"version"_s))
        return u"lds-emulator %1\n"_s.arg(QStringLiteral(LDS_VERSION));
    return parser.isSet(u"list-scenes"_s) ? sceneList() : QString();
}

tl::expected<QList<StationOptions>, QString> stationsOf(const QCommandLineParser& parser)
{
    if (parser.isSet(u"config"_s) == parser.isSet(u"sensor"_s))
        return tl::unexpected(u"give either --sensor TYPE or --config FILE; see --help"_s);
    if (!parser.isSet(u"config"_s)) {
        const auto station = stationOf(parser);
        if (!station)
            return tl::unexpected(station.error());
        return QList{*station};
    }
    for (const QString& name : sensorOptions) {
        if (parser.isSet(name))
            return tl::unexpected(
                u"--%1 belongs to --sensor; with --config it stands in the file"_s.arg(name));
    }
    return readConfigFile(parser.value(u"config"_s));
}

} // namespace

tl::expected<catalog::SensorModel, QString> modelNamed(const QString& typeName)
{
    if (const auto* model = catalog::Catalog::hlG2().findModel(typeName))
        return model->model;
    QStringList known;
    for (const auto& model : catalog::Catalog::hlG2().models())
        known.append(QString::fromLatin1(model.typeName));
    return tl::unexpected(
        u"\"%1\" is no sensor this program knows; it knows %2"_s.arg(typeName, known.join(u", "_s)));
}

tl::expected<QHostAddress, QString> bindAddress(const QString& text)
{
    const QHostAddress address(text);
    if (address.isNull())
        return tl::unexpected(u"\"%1\" is no IP address"_s.arg(text));
    return address;
}

tl::expected<EmulatorOptions, QString> parseCommandLine(const QStringList& arguments)
{
    QCommandLineParser parser;
    declareOptions(parser);
    if (!parser.parse(arguments))
        return tl::unexpected(parser.errorText());
    EmulatorOptions options;
    options.information = informationFor(parser);
    if (!options.information.isEmpty())
        return options;
    for (const QString& name : laterOptions) {
        if (parser.isSet(name))
            return tl::unexpected(
                u"--%1 is not in this version: it speaks Modbus TCP and RTU only"_s.arg(name));
    }
    if (!parser.positionalArguments().isEmpty())
        return tl::unexpected(
            u"\"%1\" is not understood; see --help"_s.arg(parser.positionalArguments().first()));
    const auto stations = stationsOf(parser);
    if (!stations)
        return tl::unexpected(stations.error());
    options.stations = *stations;
    options.fromConfig = parser.isSet(u"config"_s);
    options.panel = parser.isSet(u"panel"_s);
    options.control = parser.isSet(u"control"_s);
    if (options.control && !ControlInput::isPossible())
        return tl::unexpected(u"--control: not on this system; use --control-socket"_s);
    options.controlSocket = parser.value(u"control-socket"_s);
    if (parser.isSet(u"control-socket"_s) && options.controlSocket.isEmpty())
        return tl::unexpected(u"--control-socket: the name is empty"_s);
    return options;
}

} // namespace lds::app

#include "studio_options.h"

#include "catalog.h"

#include <QCommandLineParser>

namespace lds::app {

using namespace Qt::StringLiterals;
using catalog::Catalog;

namespace {

QString typeNames()
{
    QStringList names;
    for (const auto& model : Catalog::hlG2().models())
        names += QString::fromLatin1(model.typeName);
    return names.join(u", "_s);
}

struct Declared {
    QCommandLineOption demo{u"demo"_s, u"Connect to a virtual sensor in this program."_s};
    QCommandLineOption sensor{u"sensor"_s, u"Type of the virtual sensor: "_s + typeNames() + u"."_s,
                              u"TYPE"_s};
    QCommandLineOption connect{
        u"connect"_s, u"Connect to a sensor, for example modbus-tcp://192.168.1.6:502. May be repeated."_s,
        u"URL"_s};
    QCommandLineOption tour{
        u"tour"_s,
        u"Render the main screens on a virtual sensor into PNG files in DIR, name them, and leave."_s,
        u"DIR"_s};
    QCommandLineOption theme{u"theme"_s, u"Colours: system, light or dark."_s, u"THEME"_s};
    QCommandLineOption help{{u"h"_s, u"help"_s}, u"Show this help."_s};
    QCommandLineOption version{{u"v"_s, u"version"_s}, u"Show the version."_s};
};

std::optional<ui::ThemeMode> themeNamed(const QString& name)
{
    if (name == u"system")
        return ui::ThemeMode::System;
    if (name == u"light")
        return ui::ThemeMode::Light;
    if (name == u"dark")
        return ui::ThemeMode::Dark;
    return std::nullopt;
}

tl::expected<void, QString> takeDemo(StudioOptions& options, const QCommandLineParser& parser,
                                     const Declared& declared)
{
    const bool wanted = parser.isSet(declared.demo) || parser.isSet(declared.tour);
    if (parser.isSet(declared.sensor) && !wanted)
        return tl::unexpected(u"--sensor names the type of the virtual sensor and needs --demo beside it."_s);
    if (!wanted)
        return {};
    options.demo = catalog::SensorModel::HlG203;
    if (parser.isSet(declared.sensor)) {
        const auto* model = Catalog::hlG2().findModel(parser.value(declared.sensor));
        if (!model)
            return tl::unexpected(u"\"%1\" is no sensor type. Use one of: %2."_s.arg(
                parser.value(declared.sensor), typeNames()));
        options.demo = model->model;
    }
    return {};
}

tl::expected<void, QString> takeConnections(StudioOptions& options, const QStringList& texts)
{
    for (const QString& text : texts) {
        const auto url = ports::parseConnectionUrl(text);
        if (!url)
            return tl::unexpected(u"--connect %1: the %2 is \"%3\" where %4 is expected."_s.arg(
                text, url.error().part, url.error().found, url.error().expected));
        options.connections += *url;
    }
    return {};
}

} // namespace

tl::expected<StudioOptions, QString> parseStudioOptions(const QStringList& arguments)
{
    const Declared declared;
    QCommandLineParser parser;
    parser.setApplicationDescription(u"LDS Studio: set up and watch laser displacement sensors."_s);
    parser.addOptions({declared.demo, declared.sensor, declared.connect, declared.tour, declared.theme,
                       declared.help, declared.version});
    if (!parser.parse(arguments))
        return tl::unexpected(parser.errorText() + u" See --help."_s);
    StudioOptions options;
    if (parser.isSet(declared.help)) {
        options.information = parser.helpText();
        return options;
    }
    if (parser.isSet(declared.version)) {
        options.information = u"lds-studio %1\n"_s.arg(QLatin1StringView(LDS_VERSION));
        return options;
    }
    if (!parser.positionalArguments().isEmpty())
        return tl::unexpected(
            u"\"%1\" is not understood. See --help."_s.arg(parser.positionalArguments().first()));
    if (const auto taken = takeDemo(options, parser, declared); !taken)
        return tl::unexpected(taken.error());
    if (const auto taken = takeConnections(options, parser.values(declared.connect)); !taken)
        return tl::unexpected(taken.error());
    if (parser.isSet(declared.theme)) {
        options.theme = themeNamed(parser.value(declared.theme));
        if (!options.theme)
            return tl::unexpected(
                u"\"%1\" is no theme. Use system, light or dark."_s.arg(parser.value(declared.theme)));
    }
    if (parser.isSet(declared.tour)) {
        options.tourFolder = parser.value(declared.tour);
        if (options.tourFolder.isEmpty())
            return tl::unexpected(u"--tour needs a folder for its pictures."_s);
    }
    return options;
}

} // namespace lds::app

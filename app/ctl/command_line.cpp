#include "command_line.h"

#include "texts.h"

#include <QCommandLineParser>

namespace lds::ctl {

namespace {

struct VerbName {
    const char* name;
    Verb verb;
    const char* options; ///< Its options besides -c, --json, --help and --version; space separated.
};
constexpr VerbName verbs[] = {{"catalog", Verb::Catalog, "family"},
                              {"info", Verb::Info, ""},
                              {"read", Verb::Read, ""},
                              {"set", Verb::Set, "save"},
                              {"monitor", Verb::Monitor, "seconds interval csv"}};

tl::unexpected<UsageError> wrong(const QString& message) { return tl::unexpected(UsageError{message}); }

QString helpText()
{
    return Texts::tr(
        "Usage: ldsctl catalog [--family hl-g2] [--json]\n"
        "       ldsctl -c URL info [--json]\n"
        "       ldsctl -c URL read [KEY…] [--json]\n"
        "       ldsctl -c URL set KEY=VALUE… [--save] [--json]\n"
        "       ldsctl -c URL monitor [--seconds N] [--interval MS] [--csv FILE] [--json]\n"
        "\n"
        "Reads, sets and watches a laser displacement sensor.\n"
        "\n"
        "Commands\n"
        "  catalog   lists every item: key, menu number, name, addresses, limits, choices\n"
        "  info      tells which sensor answers and how it is\n"
        "  read      prints the items named, or all that can be read\n"
        "  set       changes items, reads back and says what the sensor holds now\n"
        "  monitor   prints a line for every measurement\n"
        "\n"
        "Options\n"
        "  -c, --connection URL   the sensor, such as modbus-tcp://192.168.1.6:502 or\n"
        "                         \"modbus-rtu:/dev/ttyUSB0?baud=38400&parity=even&stop=1&unit=1\"; add\n"
        "                         sensor=HL-G203B-S-MK to say its type, view=only to never write\n"
        "  --json                 results as JSON with stable keys and numbers in wire units\n"
        "  --family NAME          catalog: the sensor family (hl-g2)\n"
        "  --save                 set: save in the sensor afterwards, so that it outlasts power-off;\n"
        "                         every saving wears the sensor's memory\n"
        "  --seconds N            monitor: stop after so long; else at Ctrl+C\n"
        "  --interval MS          monitor: ask every so many milliseconds (default 10)\n"
        "  --csv FILE             monitor: write the measurements to a file as well\n"
        "  -h, --help             this text\n"
        "  -v, --version          the version\n"
        "\n"
        "Values of set are in the item's unit (highSetValue=1.75 is mm); a choice takes its code or its\n"
        "English name (samplingFrequency=\"200 µs\"); an address is written whole (ipAddress=192.168.1.7).\n"
        "Switches and commands are keys too (laserStop=on, measuredValueResetting=0). The order given is\n"
        "kept; settings that stand together are planned together. Nothing is written when one value is\n"
        "wrong.\n"
        "\n"
        "Exit codes: 0 done; 1 the sensor or the link refused, or there is no connection; 2 wrong usage.");
}

/// Digits with at most one point; a duration, so whole milliseconds are enough.
std::optional<int> parseSeconds(const QString& text)
{
    constexpr double longest = 1'000'000; // eleven days, far from overflow in milliseconds
    bool ok = false;
    const double seconds = text.toDouble(&ok);
    if (!ok || !(seconds >= 0.001) || seconds > longest)
        return std::nullopt;
    return int(seconds * 1000);
}

class Reader {
public:
    Reader()
    {
        m_parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
        for (const auto& [names, value] : std::initializer_list<std::pair<QStringList, QString>>{
                 {{QStringLiteral("c"), QStringLiteral("connection")}, QStringLiteral("URL")},
                 {{QStringLiteral("json")}, {}},
                 {{QStringLiteral("family")}, QStringLiteral("NAME")},
                 {{QStringLiteral("save")}, {}},
                 {{QStringLiteral("seconds")}, QStringLiteral("N")},
                 {{QStringLiteral("interval")}, QStringLiteral("MS")},
                 {{QStringLiteral("csv")}, QStringLiteral("FILE")},
                 {{QStringLiteral("h"), QStringLiteral("help")}, {}},
                 {{QStringLiteral("v"), QStringLiteral("version")}, {}}})
            m_parser.addOption(QCommandLineOption(names, {}, value));
    }

    tl::expected<std::variant<CommandLine, Answer>, UsageError> read(const QStringList& arguments)
    {
        if (!m_parser.parse(arguments))
            return wrong(m_parser.errorText());
        if (m_parser.isSet(QStringLiteral("help")))
            return Answer{helpText()};
        if (m_parser.isSet(QStringLiteral("version")))
            return Answer{QStringLiteral("ldsctl " LDS_VERSION)};
        return readVerb()
            .and_then([this] { return readConnection(); })
            .and_then([this] { return readOptions(); })
            .map([this]() -> std::variant<CommandLine, Answer> { return m_line; });
    }

private:
    using Step = tl::expected<void, UsageError>;

    Step readVerb()
    {
        QStringList words = m_parser.positionalArguments();
        if (words.isEmpty())
            return wrong(Texts::tr("say what to do: catalog, info, read, set or monitor."));
        const QString word = words.takeFirst();
        for (const VerbName& candidate : verbs) {
            if (word == QLatin1StringView(candidate.name))
                m_verb = &candidate;
        }
        if (!m_verb)
            return wrong(
                Texts::tr("unknown command “%1”; there are catalog, info, read, set and monitor.").arg(word));
        m_line.verb = m_verb->verb;
        m_line.arguments = words;
        m_line.json = m_parser.isSet(QStringLiteral("json"));
        if (!words.isEmpty() && m_line.verb != Verb::Read && m_line.verb != Verb::Set)
            return wrong(Texts::tr("%1 takes no “%2”.").arg(word, words.first()));
        return {};
    }

    Step readConnection()
    {
        const QStringList urls = m_parser.values(QStringLiteral("connection"));
        if (m_line.verb == Verb::Catalog)
            return urls.isEmpty() ? Step() : wrong(Texts::tr("catalog needs no sensor: leave -c out."));
        if (urls.size() != 1)
            return wrong(
                urls.isEmpty()
                    ? Texts::tr("%1 needs a sensor: -c modbus-tcp://ADDRESS:PORT or -c modbus-rtu:PORT.")
                          .arg(verbName())
                    : Texts::tr("-c is given more than once; one sensor at a time."));
        const auto url = ports::parseConnectionUrl(urls.first());
        if (!url) {
            return wrong(Texts::tr("-c %1: the %2 “%3” is wrong; expected %4.")
                             .arg(urls.first(), url.error().part, url.error().found, url.error().expected));
        }
        m_line.url = *url;
        return {};
    }

    Step readOptions()
    {
        const QStringList known = QString::fromLatin1(m_verb->options).split(u' ');
        for (const char* name : {"family", "save", "seconds", "interval", "csv"}) {
            const QString option = QString::fromLatin1(name);
            if (m_parser.isSet(option) && !known.contains(option))
                return wrong(Texts::tr("%1 has no option --%2.").arg(verbName(), option));
        }
        m_line.save = m_parser.isSet(QStringLiteral("save"));
        m_line.csvFile = m_parser.value(QStringLiteral("csv"));
        if (m_parser.isSet(QStringLiteral("csv")) && m_line.csvFile.isEmpty())
            return wrong(Texts::tr("--csv needs the name of a file."));
        if (m_line.verb == Verb::Set && m_line.arguments.isEmpty() && !m_line.save)
            return wrong(Texts::tr("set needs KEY=VALUE, such as highSetValue=1.75."));
        return readFamily().and_then([this] { return readTimes(); });
    }

    Step readFamily()
    {
        const QString family = m_parser.value(QStringLiteral("family"));
        if (!m_parser.isSet(QStringLiteral("family")) || family == u"hl-g2")
            return {};
        if (family == u"osm40")
            return wrong(
                Texts::tr("--family osm40: this version has no catalog of the OSM40 yet; use hl-g2."));
        return wrong(Texts::tr("--family %1: unknown family; this version has hl-g2.").arg(family));
    }

    Step readTimes()
    {
        if (m_parser.isSet(QStringLiteral("seconds"))) {
            m_line.durationMs = parseSeconds(m_parser.value(QStringLiteral("seconds")));
            if (!m_line.durationMs)
                return wrong(Texts::tr("--seconds %1: expected a number of seconds greater than 0.")
                                 .arg(m_parser.value(QStringLiteral("seconds"))));
        }
        if (m_parser.isSet(QStringLiteral("interval"))) {
            constexpr int longest = 60'000;
            bool ok = false;
            m_line.intervalMs = m_parser.value(QStringLiteral("interval")).toInt(&ok);
            if (!ok || m_line.intervalMs < 1 || m_line.intervalMs > longest)
                return wrong(Texts::tr("--interval %1: expected milliseconds from 1 to %2.")
                                 .arg(m_parser.value(QStringLiteral("interval")))
                                 .arg(longest));
        }
        return {};
    }

    QString verbName() const { return QString::fromLatin1(m_verb->name); }

    QCommandLineParser m_parser;
    const VerbName* m_verb = nullptr;
    CommandLine m_line;
};

} // namespace

tl::expected<std::variant<CommandLine, Answer>, UsageError> parseCommandLine(const QStringList& arguments)
{
    return Reader().read(arguments);
}

} // namespace lds::ctl

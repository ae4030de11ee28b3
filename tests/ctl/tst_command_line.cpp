// What a command line is taken for, before there is a sensor.

#include "command_line.h"

#include <QTest>

using namespace lds::ctl;
using namespace Qt::StringLiterals;

namespace {

auto parse(QStringList arguments)
{
    arguments.prepend(u"ldsctl"_s);
    return parseCommandLine(arguments);
}

/// Empty when the command line is right.
QString errorOf(const QStringList& arguments)
{
    const auto parsed = parse(arguments);
    return parsed ? QString() : parsed.error().message;
}

CommandLine lineOf(const QStringList& arguments)
{
    const auto parsed = parse(arguments);
    if (!parsed)
        qFatal("%s", qPrintable(parsed.error().message));
    return std::get<CommandLine>(*parsed);
}

const QString url = u"modbus-tcp://127.0.0.1:1502"_s;

} // namespace

class TestCommandLine : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void catalogNeedsNoSensor()
    {
        const CommandLine line = lineOf({u"catalog"_s, u"--family"_s, u"hl-g2"_s, u"--json"_s});
        QVERIFY(line.verb == Verb::Catalog);
        QVERIFY(line.json);
        QVERIFY(!line.url);
        QVERIFY(!lineOf({u"catalog"_s}).json);
    }

    void optionsMayStandAnywhere()
    {
        const CommandLine line =
            lineOf({u"set"_s, u"lowSetValue=-1.5"_s, u"--save"_s, u"-c"_s, url, u"span=2"_s, u"--json"_s});
        QVERIFY(line.verb == Verb::Set);
        QCOMPARE(line.arguments, QStringList({u"lowSetValue=-1.5"_s, u"span=2"_s}));
        QVERIFY(line.save);
        QVERIFY(line.json);
        QCOMPARE(line.url->port, quint16(1502));
    }

    void monitorTakesItsTimes()
    {
        const CommandLine plain = lineOf({u"-c"_s, url, u"monitor"_s});
        QVERIFY(!plain.durationMs);
        QCOMPARE(plain.intervalMs, 10);
        const CommandLine line = lineOf({u"-c"_s, url, u"monitor"_s, u"--seconds"_s, u"2.5"_s,
                                         u"--interval"_s, u"100"_s, u"--csv"_s, u"a.csv"_s});
        QCOMPARE(line.durationMs, std::optional(2500));
        QCOMPARE(line.intervalMs, 100);
        QCOMPARE(line.csvFile, u"a.csv"_s);
    }

    void wrongUsageNamesWhatIsWrong_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("named");
        QTest::newRow("nothing") << QStringList() << u"catalog, info, read, set or monitor"_s;
        QTest::newRow("unknown command") << QStringList{u"-c"_s, url, u"wirte"_s} << u"wirte"_s;
        QTest::newRow("unknown option") << QStringList{u"catalog"_s, u"--jsn"_s} << u"jsn"_s;
        QTest::newRow("no sensor") << QStringList{u"read"_s} << u"-c modbus-tcp://"_s;
        QTest::newRow("two sensors") << QStringList{u"-c"_s, url, u"-c"_s, url, u"read"_s}
                                     << u"more than once"_s;
        QTest::newRow("sensor for catalog") << QStringList{u"-c"_s, url, u"catalog"_s} << u"-c"_s;
        QTest::newRow("scheme") << QStringList{u"-c"_s, u"http://127.0.0.1"_s, u"info"_s} << u"http"_s;
        QTest::newRow("port") << QStringList{u"-c"_s, u"modbus-tcp://127.0.0.1:70000"_s, u"info"_s}
                              << u"70000"_s;
        QTest::newRow("osm40") << QStringList{u"catalog"_s, u"--family"_s, u"osm40"_s} << u"osm40"_s;
        QTest::newRow("other family")
            << QStringList{u"catalog"_s, u"--family"_s, u"x"_s} << u"unknown family"_s;
        QTest::newRow("set nothing") << QStringList{u"-c"_s, url, u"set"_s} << u"KEY=VALUE"_s;
        QTest::newRow("save while reading")
            << QStringList{u"-c"_s, url, u"read"_s, u"--save"_s} << u"--save"_s;
        QTest::newRow("seconds of set")
            << QStringList{u"-c"_s, url, u"set"_s, u"span=2"_s, u"--seconds"_s, u"1"_s} << u"--seconds"_s;
        QTest::newRow("no seconds") << QStringList{u"-c"_s, url, u"monitor"_s, u"--seconds"_s, u"0"_s}
                                    << u"--seconds 0"_s;
        QTest::newRow("seconds nan") << QStringList{u"-c"_s, url, u"monitor"_s, u"--seconds"_s, u"nan"_s}
                                     << u"--seconds nan"_s;
        QTest::newRow("endless seconds")
            << QStringList{u"-c"_s, url, u"monitor"_s, u"--seconds"_s, u"1e9"_s} << u"--seconds 1e9"_s;
        QTest::newRow("no interval") << QStringList{u"-c"_s, url, u"monitor"_s, u"--interval"_s, u"0"_s}
                                     << u"--interval 0"_s;
        QTest::newRow("no file") << QStringList{u"-c"_s, url, u"monitor"_s, u"--csv"_s, QString()}
                                 << u"--csv"_s;
        QTest::newRow("argument of info") << QStringList{u"-c"_s, url, u"info"_s, u"span"_s} << u"span"_s;
    }

    void wrongUsageNamesWhatIsWrong()
    {
        QFETCH(QStringList, arguments);
        QFETCH(QString, named);
        const QString error = errorOf(arguments);
        QVERIFY2(error.contains(named), qPrintable(error));
    }

    void saveAloneIsEnoughForSet() { QVERIFY(lineOf({u"-c"_s, url, u"set"_s, u"--save"_s}).save); }

    void helpNamesEveryCommandAndExitCode()
    {
        for (const QString& flag : {u"--help"_s, u"-h"_s}) {
            const auto parsed = parse({flag});
            QVERIFY(parsed);
            const QString text = std::get<Answer>(*parsed).text;
            for (const auto* word :
                 {"catalog", "info", "read", "set", "monitor", "--json", "--save", "Exit codes"})
                QVERIFY2(text.contains(QLatin1StringView(word)), word);
        }
    }

    void versionIsTheProjects()
    {
        const auto parsed = parse({u"--version"_s});
        QVERIFY(parsed);
        QCOMPARE(std::get<Answer>(*parsed).text, QStringLiteral("ldsctl " LDS_VERSION));
    }
};

QTEST_GUILESS_MAIN(TestCommandLine)
#include "tst_command_line.moc"

// Control lines: what they mean, what is said about wrong ones, and where lines end.
#include "control_language.h"
#include "line_splitter.h"

#include <QTest>

using namespace lds::app;
using namespace lds::emulator;
using namespace Qt::StringLiterals;

class ControlLanguageTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void understandsEveryForm();
    void namesMayHaveSpaces();
    void placesAreExact_data();
    void placesAreExact();
    void aSensorMayBeNamed();
    void wrongLinesAreToldWhatIsKnown_data();
    void wrongLinesAreToldWhatIsKnown();
    void longGarbageIsQuotedShort();

    void linesEndWithLineFeeds();
    void linesMayComeInPieces();
    void anOverlongLineIsToldOnceAndForgotten();
    void theLongestLineIsStillOne();
    void whatStandsAtTheEndIsALine();

private:
    template <typename Command>
    static Command parsed(const QString& line)
    {
        const auto command = parseControlLine(line);
        if (!command || !std::holds_alternative<Command>(command->what))
            qFatal("%s: %s", qPrintable(line), command ? "another command" : qPrintable(command.error()));
        return std::get<Command>(command->what);
    }
};

void ControlLanguageTest::understandsEveryForm()
{
    QCOMPARE(parsed<ControlCommand::Scene>(u"scene conveyor-step"_s).pathOrExample, u"conveyor-step"_s);
    QCOMPARE(parsed<ControlCommand::Scene>(u"scene gentle"_s).pathOrExample, QString());
    QCOMPARE(parsed<ControlCommand::HoldWorkpiece>(u"workpiece steel"_s).name, u"steel"_s);
    parsed<ControlCommand::LetMove>(u"workpiece moving"_s);
    const auto slow = parsed<ControlCommand::Fault>(u"fault slowAnswers on 500"_s);
    QVERIFY(slow.fault == NamedFault::SlowAnswers && slow.on && slow.milliseconds == 500);
    for (const NamedFault fault : allFaults()) {
        const auto on = parsed<ControlCommand::Fault>(u"fault %1 on"_s.arg(keyOf(fault)));
        QVERIFY(on.fault == fault && on.on && !on.milliseconds);
        const auto off = parsed<ControlCommand::Fault>(u"fault %1 off"_s.arg(keyOf(fault)));
        QVERIFY(off.fault == fault && !off.on);
    }
    QVERIFY(parsed<ControlCommand::Trigger>(u"trigger on"_s).on);
    QVERIFY(!parsed<ControlCommand::Trigger>(u"trigger off"_s).on);
    parsed<ControlCommand::PowerCycle>(u"power cycle"_s);
    parsed<ControlCommand::Status>(u"  status  "_s);
    parsed<ControlCommand::Help>(u"help"_s);
}

void ControlLanguageTest::namesMayHaveSpaces()
{
    QCOMPARE(parsed<ControlCommand::HoldWorkpiece>(u"workpiece  black rubber "_s).name, u"black rubber"_s);
    QCOMPARE(parsed<ControlCommand::Scene>(u"scene /a b/c.json"_s).pathOrExample, u"/a b/c.json"_s);
    QCOMPARE(parsed<ControlCommand::HoldWorkpiece>(u"workpiece atlas"_s).name, u"atlas"_s);
}

void ControlLanguageTest::placesAreExact_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("value");
    QTest::newRow("zero") << u"0"_s << 0;
    QTest::newRow("whole") << u"12"_s << 120'000;
    QTest::newRow("negative") << u"-1.25"_s << -12'500;
    QTest::newRow("plus") << u"+0.5"_s << 5'000;
    QTest::newRow("smallest") << u"0.0001"_s << 1;
    QTest::newRow("negative below one") << u"-0.0001"_s << -1;
    QTest::newRow("largest") << u"999.9999"_s << 9'999'999;
}

void ControlLanguageTest::placesAreExact()
{
    QFETCH(QString, text);
    QFETCH(int, value);
    QCOMPARE(parsed<ControlCommand::HoldAt>(u"workpiece at "_s + text).rawValue, value);
}

void ControlLanguageTest::aSensorMayBeNamed()
{
    const auto command = parseControlLine(u"sensor 16 fault noLight on"_s);
    QVERIFY(command.has_value());
    QCOMPARE(command->sensor, 16);
    QVERIFY(std::holds_alternative<ControlCommand::Fault>(command->what));
    QCOMPARE(parseControlLine(u"status"_s)->sensor, std::nullopt);
}

void ControlLanguageTest::wrongLinesAreToldWhatIsKnown_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("says");
    QTest::newRow("empty") << QString() << u"help"_s;
    QTest::newRow("blank") << u"   \t"_s << u"help"_s;
    QTest::newRow("no command") << u"frobnicate"_s << u"scene, workpiece, fault"_s;
    QTest::newRow("capital letters") << u"STATUS"_s << u"\"STATUS\" is no command"_s;
    QTest::newRow("no fault") << u"fault darkness on"_s << u"noLight"_s;
    QTest::newRow("no name") << u"fault"_s << u"saving"_s;
    QTest::newRow("neither on nor off") << u"fault noLight maybe"_s << u"on or off"_s;
    QTest::newRow("nothing after") << u"fault noLight"_s << u"on or off"_s;
    QTest::newRow("no milliseconds") << u"fault noLight on 5"_s << u"takes nothing more"_s;
    QTest::newRow("milliseconds of off") << u"fault slowAnswers off 5"_s << u"takes nothing more"_s;
    QTest::newRow("zero") << u"fault slowAnswers on 0"_s << u"1 to 3600000"_s;
    QTest::newRow("negative") << u"fault saving on -5"_s << u"1 to 3600000"_s;
    QTest::newRow("too long") << u"fault saving on 3600001"_s << u"1 to 3600000"_s;
    QTest::newRow("overflow") << u"fault saving on 99999999999999999999"_s << u"1 to 3600000"_s;
    QTest::newRow("a word") << u"fault saving on long"_s << u"\"long\""_s;
    QTest::newRow("two numbers") << u"fault saving on 5 6"_s << u"\"5 6\""_s;
    QTest::newRow("trigger") << u"trigger 1"_s << u"on or off"_s;
    QTest::newRow("power") << u"power off"_s << u"cycle"_s;
    QTest::newRow("scene") << u"scene"_s << u"which one"_s;
    QTest::newRow("workpiece") << u"workpiece"_s << u"which one"_s;
    QTest::newRow("place") << u"workpiece at home"_s << u"millimetres"_s;
    QTest::newRow("place too fine") << u"workpiece at 0.00001"_s << u"millimetres"_s;
    QTest::newRow("place too far") << u"workpiece at 1000"_s << u"millimetres"_s;
    QTest::newRow("status of something") << u"status now"_s << u"takes nothing more"_s;
    QTest::newRow("sensor alone") << u"sensor"_s << u"no number"_s;
    QTest::newRow("sensor without command") << u"sensor 2"_s << u"what with it"_s;
    QTest::newRow("sensor no number") << u"sensor two status"_s << u"\"two\" is no number"_s;
    QTest::newRow("sensor twice") << u"sensor 1 sensor 2 status"_s << u"is no command"_s;
}

void ControlLanguageTest::wrongLinesAreToldWhatIsKnown()
{
    QFETCH(QString, line);
    QFETCH(QString, says);
    const auto command = parseControlLine(line);
    QVERIFY(!command.has_value());
    QVERIFY2(command.error().contains(says), qPrintable(command.error()));
}

void ControlLanguageTest::longGarbageIsQuotedShort()
{
    const auto command = parseControlLine(QString(4000, u'x'));
    QVERIFY(!command.has_value());
    QVERIFY2(command.error().size() < 200, qPrintable(command.error()));
}

void ControlLanguageTest::linesEndWithLineFeeds()
{
    LineSplitter splitter(100);
    const auto lines = splitter.feed("one\ntwo\r\n\nthree");
    QCOMPARE(lines.size(), 3);
    QCOMPARE(lines.at(0).text, "one");
    QCOMPARE(lines.at(1).text, "two");
    QCOMPARE(lines.at(2).text, "");
}

void ControlLanguageTest::linesMayComeInPieces()
{
    LineSplitter splitter(100);
    for (const char* piece : {"st", "at", "us"})
        QVERIFY(splitter.feed(piece).isEmpty());
    const auto lines = splitter.feed("\nhe");
    QCOMPARE(lines.size(), 1);
    QCOMPARE(lines.first().text, "status");
    QCOMPARE(splitter.feed("lp\n").first().text, "help");
}

void ControlLanguageTest::anOverlongLineIsToldOnceAndForgotten()
{
    LineSplitter splitter(10);
    for (int i = 0; i < 1000; ++i)
        QVERIFY(splitter.feed("0123456789").isEmpty());
    const auto lines = splitter.feed("tail\nstatus\n");
    QCOMPARE(lines.size(), 2);
    QVERIFY(lines.at(0).overlong && lines.at(0).text.isEmpty());
    QVERIFY(!lines.at(1).overlong);
    QCOMPARE(lines.at(1).text, "status");
}

void ControlLanguageTest::theLongestLineIsStillOne()
{
    LineSplitter splitter(10);
    QCOMPARE(splitter.feed("0123456789\n").first().text, "0123456789");
    QVERIFY(splitter.feed("0123456789a\n").first().overlong);
}

void ControlLanguageTest::whatStandsAtTheEndIsALine()
{
    LineSplitter splitter(10);
    QVERIFY(!splitter.rest());
    splitter.feed("help\nstatus");
    QCOMPARE(splitter.rest()->text, "status");
    QVERIFY(!splitter.rest());
    splitter.feed("0123456789a");
    QVERIFY(splitter.rest()->overlong);
}

QTEST_GUILESS_MAIN(ControlLanguageTest)
#include "tst_control_language.moc"

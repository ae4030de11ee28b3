#include "conformance_table.h"
#include "test_programs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace lds::test;
using namespace Qt::StringLiterals;

namespace {

const QString head = u"## 4.2 Bank Switching\n\n| id | statement | where | test |\n|---|---|---|---|\n"_s;

QString rowWith(const QString& tests, const QString& place = u"virtual sensor"_s)
{
    return u"| 4.2-1 | Four banks | %1 | %2 |\n"_s.arg(place, tests);
}

} // namespace

class ConformanceTableTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aRowTellsWhatHoldsIt();
    void aRowMayTellWhyNothingHoldsIt();
    void openPointsAreNoStatements();
    void malformedRowsAreNamedByLine_data();
    void malformedRowsAreNamedByLine();
    void sectionsWithoutAStatementAreTold();

    void ctestsFilesTellTheRegisteredTests();
    void aTestThatExistsIsNoObjection();
    void unknownProgramsAndFunctionsAreObjectedTo();
    void aProgramThatIsNotBuiltIsSaidToBeSo();
};

void ConformanceTableTest::aRowTellsWhatHoldsIt()
{
    const ConformanceTable table = readConformanceTable(
        head + u"| 4.2-1 | Four banks | virtual sensor, front panel | `tst_a::one`, `tst_b::two` |\n"_s);
    QCOMPARE(table.problems, QStringList());
    QCOMPARE(table.statements.size(), 1);
    const Statement& statement = table.statements.first();
    QCOMPARE(statement.id, u"4.2-1"_s);
    QCOMPARE(statement.section, u"4.2"_s);
    QCOMPARE(statement.text, u"Four banks"_s);
    QCOMPARE(statement.places, (QStringList{u"virtual sensor"_s, u"front panel"_s}));
    QCOMPARE(statement.tests, (QList<TestName>{{u"tst_a"_s, u"one"_s}, {u"tst_b"_s, u"two"_s}}));
    QCOMPARE(statement.reason, QString());
    QCOMPARE(statement.line, 5);
}

void ConformanceTableTest::aRowMayTellWhyNothingHoldsIt()
{
    const ConformanceTable table =
        readConformanceTable(head + rowWith(u"none: mechanical, of the housing"_s, u"—"_s));
    QCOMPARE(table.problems, QStringList());
    QVERIFY(table.statements.first().tests.isEmpty());
    QCOMPARE(table.statements.first().reason, u"mechanical, of the housing"_s);
}

void ConformanceTableTest::openPointsAreNoStatements()
{
    const ConformanceTable table = readConformanceTable(
        u"## Open points\n\n| § | open point | choice |\n|---|---|---|\n| 4.2 | a | b |\n"_s);
    QCOMPARE(table.problems, QStringList());
    QVERIFY(table.statements.isEmpty());
}

void ConformanceTableTest::malformedRowsAreNamedByLine_data()
{
    QTest::addColumn<QString>("markdown");
    QTest::addColumn<QString>("problem"); ///< The only one, or its beginning.

    const QString good = rowWith(u"`tst_a::one`"_s);
    const auto row = [](const char* name, const QString& markdown, const QString& problem) {
        QTest::newRow(name) << markdown << problem;
    };
    row("an id twice", head + good + good, u"line 6: 4.2-1 occurs twice, first in line 5"_s);
    row("an id of another section", head + u"| 4.3-1 | a | virtual sensor | `tst_a::one` |"_s,
        u"line 5: 4.3-1 stands under"_s);
    row("no id", head + u"| 4.2 | a | virtual sensor | `tst_a::one` |"_s, u"line 5: \"4.2\" is no id"_s);
    row("a number from nought", head + u"| 4.2-0 | a | virtual sensor | `tst_a::one` |"_s,
        u"line 5: \"4.2-0\" is no id"_s);
    row("under no section", u"# Title\n\n"_s + head.section(u'\n', 2) + good,
        u"line 5: 4.2-1 stands under"_s);
    row("an empty test cell", head + u"| 4.2-1 | a | virtual sensor |  |"_s, u"line 5: a cell is empty"_s);
    row("an empty statement", head + u"| 4.2-1 | | virtual sensor | `tst_a::one` |"_s,
        u"line 5: a cell is empty"_s);
    row("three cells", head + u"| 4.2-1 | a | `tst_a::one` |"_s, u"line 5: the row has 3 cells"_s);
    row("five cells", head + u"| 4.2-1 | a | virtual sensor | b | `tst_a::one` |"_s,
        u"line 5: the row has 5 cells"_s);
    row("no bar at its end", head + u"| 4.2-1 | a | virtual sensor | `tst_a::one`"_s,
        u"line 5: the row has 0 cells"_s);
    row("no bar at its beginning", head + u"4.2-1 | a | virtual sensor | `tst_a::one` |"_s,
        u"line 5: a table ends with an empty line"_s);
    row("a name without quotes", head + rowWith(u"tst_a::one"_s),
        u"line 5: 4.2-1: \"tst_a::one\" is neither"_s);
    row("a name without function", head + rowWith(u"`tst_a`"_s), u"line 5: 4.2-1: \"`tst_a`\" is neither"_s);
    row("a forgotten comma", head + rowWith(u"`tst_a::one` `tst_a::two`"_s), u"line 5: 4.2-1"_s);
    row("the same test twice", head + rowWith(u"`tst_a::one`, `tst_a::one`"_s), u"line 5: 4.2-1 names"_s);
    row("a reason that is none", head + rowWith(u"none: optical"_s, u"—"_s), u"line 5: 4.2-1: \"optical\""_s);
    row("a place where nothing is", head + rowWith(u"none: mechanical, of the housing"_s),
        u"line 5: 4.2-1 is held by no test"_s);
    row("an unknown place", head + rowWith(u"`tst_a::one`"_s, u"sensor"_s), u"line 5: 4.2-1: \"sensor\""_s);
    row("no place", head + rowWith(u"`tst_a::one`"_s, u"—"_s), u"line 5: 4.2-1: \"—\""_s);
    row("an unknown table", u"| a | b |\n|---|---|\n"_s, u"line 1: unknown table header"_s);
    row("no line under the header", u"| § | open point | choice |\n| 4.2 | a | b |\n"_s,
        u"line 2: a line of ---"_s);
    row("a row of no table", head + u"\n4.2-1 | a | b | c\n"_s, u"line 6: looks like a row"_s);
    row("an empty choice", u"| § | open point | choice |\n|---|---|---|\n| 4.2 | a | |\n"_s,
        u"line 3: a cell is empty"_s);
}

void ConformanceTableTest::malformedRowsAreNamedByLine()
{
    QFETCH(QString, markdown);
    QFETCH(QString, problem);
    const QStringList problems = readConformanceTable(markdown).problems;
    QVERIFY(!problems.isEmpty());
    QVERIFY2(problems.first().startsWith(problem), qPrintable(problems.join(u'\n')));
}

void ConformanceTableTest::sectionsWithoutAStatementAreTold()
{
    const ConformanceTable table = readConformanceTable(head + rowWith(u"`tst_a::one`"_s));
    QCOMPARE(sectionsWithoutStatement(table, {u"4.2"_s}), QStringList());
    QCOMPARE(sectionsWithoutStatement(table, {u"4.1"_s, u"4.2"_s, u"4.2.1"_s}),
             (QStringList{u"4.1"_s, u"4.2.1"_s}));
}

void ConformanceTableTest::ctestsFilesTellTheRegisteredTests()
{
    const QString file = u"# add_tests of ours\n"
                         "add_test([=[tst_new]=] \"/build/tests/tst_new\")\n"
                         "set_tests_properties([=[tst_new]=] PROPERTIES TIMEOUT 120)\n"
                         "add_test(tst_old \"/build/tests/tst_old\")\nsubdirs(\"catalog\")\n"_s;
    QCOMPARE(registeredTests(file), (QSet<QString>{u"tst_new"_s, u"tst_old"_s}));
}

void ConformanceTableTest::aTestThatExistsIsNoObjection()
{
    TestPrograms programs(QCoreApplication::applicationDirPath());
    const TestName self{u"tst_conformance_table"_s, u"aTestThatExistsIsNoObjection"_s};
    QCOMPARE(programs.objection(self), QString());
    QCOMPARE(programs.objection(self), QString()); // from what it was told before
}

void ConformanceTableTest::unknownProgramsAndFunctionsAreObjectedTo()
{
    TestPrograms programs(QCoreApplication::applicationDirPath());
    // A function that stands in this very source, but only here: aTestThatIsOnlyACommentIsNone
    const QString function =
        programs.objection({u"tst_conformance_table"_s, u"aTestThatIsOnlyACommentIsNone"_s});
    QVERIFY2(function.contains(u"has no test function"_s), qPrintable(function));
    // Data functions belong to their test and are none by themselves.
    const QString data =
        programs.objection({u"tst_conformance_table"_s, u"malformedRowsAreNamedByLine_data"_s});
    QVERIFY2(data.contains(u"has no test function"_s), qPrintable(data));
    const QString program = programs.objection({u"tst_of_nothing"_s, u"anything"_s});
    QVERIFY2(program.contains(u"no test program tst_of_nothing"_s), qPrintable(program));
}

void ConformanceTableTest::aProgramThatIsNotBuiltIsSaidToBeSo()
{
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkpath(u"emulator"_s));
    QFile ctest(folder.filePath(u"emulator/CTestTestfile.cmake"_s));
    QVERIFY(ctest.open(QIODevice::WriteOnly));
    ctest.write("add_test([=[tst_x]=] \"tst_x\")\nadd_test([=[tst_y]=] \"tst_y\")\n");
    ctest.close();
    QFile broken(folder.filePath(u"tst_y"_s)); // registered and there, but it cannot be run
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.close();
    QVERIFY(broken.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
    TestPrograms programs(folder.path());
    QCOMPARE(programs.registered(), (QSet<QString>{u"tst_x"_s, u"tst_y"_s}));
    QVERIFY(programs.objection({u"tst_x"_s, u"anything"_s}).contains(u"is not built"_s));
    QVERIFY(programs.objection({u"tst_y"_s, u"anything"_s}).contains(u"-functions"_s));
}

QTEST_GUILESS_MAIN(ConformanceTableTest)
#include "tst_conformance_table.moc"

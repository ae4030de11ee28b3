#include "conformance_table.h"

#include <QHash>
#include <QRegularExpression>

namespace lds::test {

using namespace Qt::StringLiterals;

namespace {

const QString statementHeader = u"| id | statement | where | test |"_s;
const QString openPointHeader = u"| § | open point | choice |"_s;
const QString noTest = u"none: "_s;
constexpr int shortestReason = 12; ///< Letters; less is a word that excuses nothing.

/// One pass over the lines of the document.
class Reader {
public:
    ConformanceTable read(const QString& markdown);

private:
    enum class Table { None, Statements, OpenPoints };

    void readLine(const QString& line);
    void readHeading(const QString& line);
    void openTable(const QString& line);
    void readRow(const QString& line);
    void readStatement(const QStringList& cells);
    void readId(Statement& statement);
    void readPlaces(Statement& statement, const QString& cell);
    void readTests(Statement& statement, const QString& cell);
    void problem(const QString& what) { m_result.problems.append(u"line %1: %2"_s.arg(m_line).arg(what)); }

    ConformanceTable m_result;
    QHash<QString, int> m_lineOfId;
    QString m_section; ///< Of the heading above; empty under one without a number.
    Table m_table = Table::None;
    int m_columns = 0;
    bool m_expectsRule = false; ///< The line of dashes under a header.
    int m_line = 0;
};

/// The cells between the bars, trimmed; nothing when the line is no table row at all.
QStringList cellsOf(const QString& line)
{
    if (line.size() < 2 || !line.startsWith(u'|') || !line.endsWith(u'|'))
        return {};
    QStringList cells = line.mid(1, line.size() - 2).split(u'|');
    for (QString& cell : cells)
        cell = cell.trimmed();
    return cells;
}

ConformanceTable Reader::read(const QString& markdown)
{
    const QStringList lines = markdown.split(u'\n');
    for (const QString& line : lines) {
        ++m_line;
        readLine(line);
    }
    return m_result;
}

void Reader::readLine(const QString& line)
{
    if (line.startsWith(u'|')) {
        if (m_table == Table::None)
            openTable(line);
        else
            readRow(line);
        return;
    }
    if (m_table != Table::None && !line.isEmpty())
        problem(u"a table ends with an empty line; is this a broken row?"_s);
    m_table = Table::None;
    if (line.startsWith(u'#'))
        readHeading(line);
    else if (line.contains(u'|') || line.contains(u"::"_s))
        problem(u"looks like a row that does not begin with a bar"_s);
}

void Reader::readHeading(const QString& line)
{
    static const QRegularExpression numbered(u"^#+ (\\d+(?:\\.\\d+)*) "_s);
    m_section = numbered.match(line).captured(1);
}

void Reader::openTable(const QString& line)
{
    m_expectsRule = true;
    m_columns = int(cellsOf(line).size());
    if (line == statementHeader) {
        m_table = Table::Statements;
        return;
    }
    m_table = Table::OpenPoints;
    if (line != openPointHeader)
        problem(u"unknown table header; expected \"%1\" or \"%2\""_s.arg(statementHeader, openPointHeader));
}

void Reader::readRow(const QString& line)
{
    const QStringList cells = cellsOf(line);
    if (cells.size() != m_columns) {
        problem(u"the row has %1 cells, its table has %2"_s.arg(cells.size()).arg(m_columns));
        return;
    }
    if (std::exchange(m_expectsRule, false)) {
        for (const QString& cell : cells) {
            if (cell != u"---"_s)
                problem(u"a line of --- belongs under the header"_s);
        }
        return;
    }
    for (const QString& cell : cells) {
        if (cell.isEmpty()) {
            problem(u"a cell is empty"_s);
            return;
        }
    }
    if (m_table == Table::Statements)
        readStatement(cells);
}

void Reader::readStatement(const QStringList& cells)
{
    Statement statement;
    statement.line = m_line;
    statement.id = cells.at(0);
    statement.text = cells.at(1);
    readId(statement);
    readTests(statement, cells.at(3));
    readPlaces(statement, cells.at(2));
    m_result.statements.append(statement);
}

void Reader::readId(Statement& statement)
{
    static const QRegularExpression form(u"^(\\d+(?:\\.\\d+)*)-([1-9]\\d*)$"_s);
    const auto match = form.match(statement.id);
    statement.section = match.captured(1);
    if (!match.hasMatch())
        problem(u"\"%1\" is no id; ids look like 4.3.2-1"_s.arg(statement.id));
    else if (statement.section != m_section)
        problem(u"%1 stands under the heading of section \"%2\""_s.arg(statement.id, m_section));
    if (m_lineOfId.contains(statement.id))
        problem(u"%1 occurs twice, first in line %2"_s.arg(statement.id).arg(m_lineOfId[statement.id]));
    else
        m_lineOfId.insert(statement.id, m_line);
}

void Reader::readPlaces(Statement& statement, const QString& cell)
{
    if (statement.tests.isEmpty()) {
        if (cell != u"—"_s)
            problem(u"%1 is held by no test, so its place has to be —"_s.arg(statement.id));
        return;
    }
    statement.places = cell.split(u", "_s);
    for (const QString& place : std::as_const(statement.places)) {
        if (!statementPlaces().contains(place))
            problem(u"%1: \"%2\" is none of: %3"_s.arg(statement.id, place, statementPlaces().join(u", "_s)));
    }
}

void Reader::readTests(Statement& statement, const QString& cell)
{
    if (cell.startsWith(noTest)) {
        statement.reason = cell.mid(noTest.size());
        if (statement.reason.size() < shortestReason)
            problem(u"%1: \"%2\" is no reason"_s.arg(statement.id, statement.reason));
        return;
    }
    static const QRegularExpression form(u"^`([a-z0-9_]+)::([A-Za-z_][A-Za-z0-9_]*)`$"_s);
    const QStringList names = cell.split(u", "_s);
    for (const QString& name : names) {
        const auto match = form.match(name);
        if (!match.hasMatch()) {
            problem(
                u"%1: \"%2\" is neither `program::function` nor \"none: reason\""_s.arg(statement.id, name));
            continue;
        }
        const TestName test{match.captured(1), match.captured(2)};
        if (statement.tests.contains(test))
            problem(u"%1 names %2 twice"_s.arg(statement.id, name));
        statement.tests.append(test);
    }
}

} // namespace

const QStringList& statementPlaces()
{
    static const QStringList places{u"virtual sensor"_s, u"front panel"_s, u"Modbus server"_s,
                                    u"RS-485 line"_s, u"catalog"_s};
    return places;
}

ConformanceTable readConformanceTable(const QString& markdown) { return Reader().read(markdown); }

QStringList sectionsWithoutStatement(const ConformanceTable& table, const QStringList& sections)
{
    QStringList missing = sections;
    for (const Statement& statement : table.statements)
        missing.removeAll(statement.section);
    return missing;
}

} // namespace lds::test

#pragma once

#include <QList>
#include <QString>
#include <QStringList>

namespace lds::test {

/// A test as the table names it: `program::function`.
struct TestName {
    QString program;
    QString function;
    bool operator==(const TestName&) const = default;
};

/// One statement of the manual and what holds it.
struct Statement {
    QString id;            ///< "4.3.2-1": the manual's section and a number within it.
    QString section;       ///< "4.3.2"
    QString text;          ///< What the manual asks for, in our words.
    QStringList places;    ///< Where it lives; of statementPlaces().
    QList<TestName> tests; ///< What holds it; empty exactly when there is a reason.
    QString reason;        ///< Why no program can hold it.
    int line = 0;          ///< In the document, from 1.
};

/// What docs/conformance.md says, and what is wrong with how it says it.
struct ConformanceTable {
    QList<Statement> statements;
    QStringList problems; ///< Each begins with "line N: ".
};

/// Words of the column "where", besides "—" for a statement that is not held by a program.
const QStringList& statementPlaces();

/// Reads every table row, strictly: a row that is not understood is a problem, never skipped. Also found
/// here: an id that occurs twice, an id under another section's heading, a row that names neither a test
/// nor a reason.
ConformanceTable readConformanceTable(const QString& markdown);

/// Those of `sections` that have no statement.
QStringList sectionsWithoutStatement(const ConformanceTable& table, const QStringList& sections);

} // namespace lds::test

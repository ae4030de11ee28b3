#include "conformance_table.h"
#include "test_programs.h"

#include <QCoreApplication>
#include <QFile>
#include <QMap>
#include <QTest>

using namespace lds::test;
using namespace Qt::StringLiterals;

namespace {

/// The sections of chapters 4, 5.1, 5.2 and 6 that state something of their own, as the manual numbers them.
const QStringList& sections()
{
    static const QStringList all{
        u"4.1"_s,   u"4.2"_s,   u"4.3.1"_s,  u"4.3.2"_s,  u"4.3.3"_s, u"4.3.4"_s, u"4.3.5"_s, u"4.3.6"_s,
        u"4.3.7"_s, u"4.4.1"_s, u"4.4.2"_s,  u"4.4.3"_s,  u"4.4.4"_s, u"4.4.5"_s, u"4.5.1"_s, u"4.5.2"_s,
        u"4.6.1"_s, u"4.6.2"_s, u"4.7"_s,    u"4.7.1"_s,  u"4.7.2"_s, u"4.8.1"_s, u"4.8.2"_s, u"4.8.3"_s,
        u"4.8.4"_s, u"4.8.5"_s, u"4.8.6"_s,  u"4.9"_s,    u"4.9.1"_s, u"4.9.2"_s, u"4.9.3"_s, u"4.10"_s,
        u"4.11"_s,  u"4.12"_s,  u"4.12.1"_s, u"4.12.2"_s, u"4.13"_s,  u"5.1"_s,   u"5.1.1"_s, u"5.2"_s,
        u"5.2.1"_s, u"5.2.2"_s, u"5.2.3"_s,  u"5.2.4"_s,  u"5.2.5"_s};
    return all;
}

/// Every line as a warning, since a failure's text is cut short; answers with what fails.
QByteArray told(const QStringList& lines)
{
    for (const QString& line : lines)
        qWarning().noquote() << "docs/conformance.md" << line;
    return QByteArray::number(lines.size()) + " in docs/conformance.md, named above";
}

} // namespace

/// docs/conformance.md says for each statement of the manual which test holds it. Here it is held to that.
class ConformanceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void everyRowIsWellFormed();
    void everySectionHasAStatement();
    void everyTestNamedExists();

private:
    ConformanceTable m_table;
};

void ConformanceTest::initTestCase()
{
    const QString source = qEnvironmentVariable("LDS_SOURCE");
    QVERIFY2(!source.isEmpty(), "LDS_SOURCE names the source folder; ctest sets it");
    QFile file(source + u"/docs/conformance.md"_s);
    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName() + u": "_s + file.errorString()));
    m_table = readConformanceTable(QString::fromUtf8(file.readAll()));
    QVERIFY2(!m_table.statements.isEmpty(), "docs/conformance.md has no statement");
}

void ConformanceTest::everyRowIsWellFormed() { QVERIFY2(m_table.problems.isEmpty(), told(m_table.problems)); }

void ConformanceTest::everySectionHasAStatement()
{
    const QStringList missing = sectionsWithoutStatement(m_table, sections());
    QVERIFY2(missing.isEmpty(), qPrintable(u"no statement of "_s + missing.join(u", "_s)));
}

void ConformanceTest::everyTestNamedExists()
{
    TestPrograms programs(QCoreApplication::applicationDirPath());
    QMap<QString, QStringList> rows; // by what is objected to them
    for (const Statement& statement : std::as_const(m_table.statements)) {
        for (const TestName& test : statement.tests) {
            const QString objection = programs.objection(test);
            if (!objection.isEmpty())
                rows[objection].append(u"%1 (line %2)"_s.arg(statement.id).arg(statement.line));
        }
    }
    QStringList objections;
    for (auto it = rows.constBegin(); it != rows.constEnd(); ++it)
        objections.append(it.key() + u": "_s + it->join(u", "_s));
    QVERIFY2(objections.isEmpty(), told(objections));
}

QTEST_GUILESS_MAIN(ConformanceTest)
#include "tst_conformance.moc"

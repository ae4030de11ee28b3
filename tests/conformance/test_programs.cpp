#include "test_programs.h"

#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QProcessEnvironment>
#include <QRegularExpression>

namespace lds::test {

using namespace Qt::StringLiterals;

namespace {
constexpr int longestAnswerMs = 20'000; ///< For listing its functions; a sanitized program takes its time.
}

QSet<QString> registeredTests(const QString& ctestFile)
{
    // add_test([=[name]=] "program") since CMake 3.16, add_test(name "program") before.
    static const QRegularExpression form(u"add_test\\((?:\\[=+\\[([^\\]]+)\\]=+\\]|([^\\s\\[)]+))"_s);
    QSet<QString> names;
    for (const QRegularExpressionMatch& match : form.globalMatch(ctestFile))
        names.insert(match.captured(1) + match.captured(2));
    return names;
}

TestPrograms::TestPrograms(const QString& folder)
    : m_folder(folder)
{
    QDirIterator files(folder, {u"CTestTestfile.cmake"_s}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (file.open(QIODevice::ReadOnly))
            m_registered.unite(registeredTests(QString::fromUtf8(file.readAll())));
    }
}

QString TestPrograms::objection(const TestName& test)
{
    if (!m_registered.contains(test.program))
        return u"no test program %1 is registered by a CMakeLists.txt"_s.arg(test.program);
    auto functions = m_functions.constFind(test.program);
    if (functions == m_functions.constEnd())
        functions = m_functions.insert(test.program, ask(test.program));
    if (!functions->has_value())
        return functions->error();
    if (!(*functions)->contains(test.function))
        return u"%1 has no test function %2"_s.arg(test.program, test.function);
    return {};
}

TestPrograms::Functions TestPrograms::ask(const QString& program) const
{
    const QString path = m_folder + u'/' + program;
    if (!QFileInfo(path).isExecutable())
        return tl::unexpected(u"%1 is not built; build everything before running this test"_s.arg(path));
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"QT_QPA_PLATFORM"_s, u"offscreen"_s);
    process.setProcessEnvironment(environment);
    process.start(path, {u"-functions"_s});
    if (!process.waitForFinished(longestAnswerMs)) {
        process.kill();
        process.waitForFinished();
        return tl::unexpected(u"%1 -functions does not end: %2"_s.arg(path, process.errorString()));
    }
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        return tl::unexpected(u"%1 -functions failed"_s.arg(path));
    QSet<QString> names;
    const QStringList lines = QString::fromUtf8(process.readAllStandardOutput()).split(u'\n');
    for (const QString& line : lines) {
        if (line.trimmed().endsWith(u"()"_s))
            names.insert(line.trimmed().chopped(2));
    }
    return names;
}

} // namespace lds::test

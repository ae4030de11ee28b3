#pragma once

#include "conformance_table.h"

#include <QHash>
#include <QSet>
#include <QString>
#include <tl/expected.hpp>

namespace lds::test {

/// The test programs of one build. A name that stands only in a comment of the source, or in a source that
/// nothing builds, would hold nothing; so the truth is what ctest runs (CTestTestfile.cmake) and what the
/// programs themselves list (-functions), not what the sources contain. Where everything is built before
/// ctest runs, as scripts/test does, every program is there; one that is not built is said to be so. There
/// is no second way that looks into the sources: two truths could differ.
class TestPrograms {
public:
    /// `folder`: <build>/tests, with the programs and, below it, ctest's files.
    explicit TestPrograms(const QString& folder);

    /// Why this test cannot be relied on; empty when it exists. Asks each program once.
    QString objection(const TestName& test);
    const QSet<QString>& registered() const { return m_registered; } ///< Names that ctest runs.

private:
    using Functions = tl::expected<QSet<QString>, QString>;
    Functions ask(const QString& program) const;

    QString m_folder;
    QSet<QString> m_registered;
    QHash<QString, Functions> m_functions;
};

/// The names that a CTestTestfile.cmake registers.
QSet<QString> registeredTests(const QString& ctestFile);

} // namespace lds::test

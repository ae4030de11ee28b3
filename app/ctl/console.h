#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

class QIODevice;

namespace lds::ctl {

/// Results go to standard output, messages to standard error; both UTF-8, both at once.
class Console {
public:
    Console(QIODevice& output, QIODevice& errors);

    void line(const QString& text);
    void json(const QJsonArray& array);
    void json(const QJsonObject& object);
    void jsonLine(const QJsonObject& object); ///< Compact, for a stream of objects.
    /// A message for a person: "ldsctl: …". Says what, where and what to do.
    void message(const QString& text);

private:
    QIODevice& m_output;
    QIODevice& m_errors;
};

/// Texts one under the other with the cells of each column aligned; the last column is not padded.
QStringList alignedLines(const QList<QStringList>& rows);

} // namespace lds::ctl

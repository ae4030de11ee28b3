#include "console.h"

#include <QFileDevice>
#include <QIODevice>
#include <QJsonDocument>

#include <algorithm>

namespace lds::ctl {

namespace {

void write(QIODevice& device, const QByteArray& bytes)
{
    device.write(bytes);
    if (auto* file = qobject_cast<QFileDevice*>(&device))
        file->flush();
}

} // namespace

Console::Console(QIODevice& output, QIODevice& errors)
    : m_output(output)
    , m_errors(errors)
{}

void Console::line(const QString& text) { write(m_output, text.toUtf8() + '\n'); }

void Console::json(const QJsonArray& array) { write(m_output, QJsonDocument(array).toJson()); }

void Console::json(const QJsonObject& object) { write(m_output, QJsonDocument(object).toJson()); }

void Console::jsonLine(const QJsonObject& object)
{
    write(m_output, QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n');
}

void Console::message(const QString& text) { write(m_errors, "ldsctl: " + text.toUtf8() + '\n'); }

QStringList alignedLines(const QList<QStringList>& rows)
{
    QList<qsizetype> widths;
    for (const QStringList& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (qsizetype column = 0; column < row.size(); ++column)
            widths[column] = std::max(widths[column], row[column].size());
    }
    QStringList lines;
    for (const QStringList& row : rows) {
        QString line;
        for (qsizetype column = 0; column < row.size(); ++column)
            line += column + 1 < row.size() ? row[column].leftJustified(widths[column] + 2) : row[column];
        while (line.endsWith(u' '))
            line.chop(1);
        lines += line;
    }
    return lines;
}

} // namespace lds::ctl

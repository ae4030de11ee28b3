#include "message_export.h"

#include "message_text.h"

#include <QSaveFile>

namespace lds::ui {

MessageFileFormat formatOf(const QString& path)
{
    return path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive) ? MessageFileFormat::Csv
                                                                      : MessageFileFormat::Text;
}

QByteArray messageFile(const QList<ports::Frame>& frames, MessageFileFormat format)
{
    const bool csv = format == MessageFileFormat::Csv;
    const auto line = [csv](const QStringList& fields) {
        return csv ? csvLine(fields) + QStringLiteral("\r\n") : tabLine(fields) + QLatin1Char('\n');
    };
    // The mark tells spreadsheets that this is UTF-8; RFC 4180 ends lines with CR LF.
    QByteArray content = csv ? QByteArray("\xef\xbb\xbf") : QByteArray();
    content += line(messageFieldNames()).toUtf8();
    for (const ports::Frame& frame : frames)
        content += line(messageFields(frame)).toUtf8();
    return content;
}

tl::expected<void, QString> saveMessages(const QString& path, const QList<ports::Frame>& frames)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(file.errorString());
    const QByteArray content = messageFile(frames, formatOf(path));
    if (file.write(content) != content.size() || !file.commit())
        return tl::unexpected(file.errorString());
    return {};
}

} // namespace lds::ui

#include "message_text.h"

#include "sentences.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

namespace lds::ui {

namespace {
QString tr(const char* text, int n = -1)
{
    return QCoreApplication::translate("lds::ui::MessagesPage", text, nullptr, n);
}
} // namespace

QString hexText(const QByteArray& bytes) { return QString::fromLatin1(bytes.toHex(' ')).toUpper(); }

QString messageTime(const ports::Frame& frame)
{
    return QDateTime::fromMSecsSinceEpoch(frame.wallMs).toString(QStringLiteral("HH:mm:ss.zzz"));
}

QString directionWord(ports::Direction direction)
{
    return direction == ports::Direction::Sent ? tr("sent") : tr("received");
}

QString directionSign(ports::Direction direction)
{
    return direction == ports::Direction::Sent ? QStringLiteral("→") : QStringLiteral("←");
}

QString roundTripText(const ports::Frame& frame)
{
    return frame.roundTripNs < 0 ? QString() : QLocale::c().toString(double(frame.roundTripNs) / 1e6, 'f', 1);
}

QString reconstructedNote(const ports::Frame& frame)
{
    if (frame.reconstructedPrefix <= 0)
        return {};
    return tr("The first %n byte(s), dimmed, are reconstructed: only the message itself was seen, not the "
              "header around it.",
              frame.reconstructedPrefix);
}

QStringList messageFields(const ports::Frame& frame)
{
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(frame.wallMs);
    return {time.toOffsetFromUtc(time.offsetFromUtc()).toString(Qt::ISODateWithMs),
            directionWord(frame.direction),
            roundTripText(frame),
            frameSentence(frame),
            hexText(frame.bytes),
            QString::number(frame.reconstructedPrefix),
            frame.protocol,
            frame.peer};
}

QStringList messageFieldNames()
{
    return {tr("Time"),     tr("Direction"), tr("Round trip (ms)"),
            tr("Message"),  tr("Bytes"),     tr("Reconstructed leading bytes"),
            tr("Protocol"), tr("Sensor")};
}

QString csvLine(const QStringList& fields)
{
    QStringList escaped;
    for (QString field : fields) {
        const bool special = field.contains(QLatin1Char(',')) || field.contains(QLatin1Char('"')) ||
                             field.contains(QLatin1Char('\n')) || field.contains(QLatin1Char('\r'));
        if (special) {
            field.replace(QLatin1Char('"'), QStringLiteral("\"\""));
            field = QLatin1Char('"') + field + QLatin1Char('"');
        }
        escaped.append(field);
    }
    return escaped.join(QLatin1Char(','));
}

QString tabLine(const QStringList& fields)
{
    QStringList plain;
    for (QString field : fields) {
        for (const QChar separator : {QLatin1Char('\t'), QLatin1Char('\n'), QLatin1Char('\r')})
            field.replace(separator, QLatin1Char(' '));
        plain.append(field);
    }
    return plain.join(QLatin1Char('\t'));
}

} // namespace lds::ui

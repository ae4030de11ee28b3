#include "message_text.h"

#include "sentences.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

namespace lds::ui {

namespace {
struct MessageTexts {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::MessageTexts)
};
} // namespace

QString hexText(const QByteArray& bytes) { return QString::fromLatin1(bytes.toHex(' ')).toUpper(); }

QString messageTime(const ports::Frame& frame)
{
    return QDateTime::fromMSecsSinceEpoch(frame.wallMs).toString(QStringLiteral("HH:mm:ss.zzz"));
}

QString directionWord(ports::Direction direction)
{
    return direction == ports::Direction::Sent ? MessageTexts::tr("sent") : MessageTexts::tr("received");
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
    return MessageTexts::tr(
        "Dimmed bytes are reconstructed: only the message itself was seen, not the header "
        "around it.");
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
    return {MessageTexts::tr("Time"),
            MessageTexts::tr("Direction"),
            MessageTexts::tr("Round trip (ms)"),
            MessageTexts::tr("Message"),
            MessageTexts::tr("Bytes"),
            MessageTexts::tr("Reconstructed leading bytes"),
            MessageTexts::tr("Protocol"),
            MessageTexts::tr("Sensor")};
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

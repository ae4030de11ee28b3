#include "sentence_parts.h"
#include "sentences.h"

namespace lds::ui {

namespace {

int numberOf(const QString& text)
{
    return text.startsWith(QStringLiteral("0x"), Qt::CaseInsensitive) ? text.mid(2).toInt(nullptr, 16)
                                                                      : text.toInt();
}

QString span(const ports::Frame& frame)
{
    const QString first = frame.arguments.value(0);
    const QString last = frame.arguments.value(1);
    return last.isEmpty() || first == last ? first : first + QChar(0x2013) + last;
}

/// "read", "write": what the function code of a refused request asked for (§5.2.2).
QString functionWords(int code)
{
    switch (code & 0x7f) {
    case 0x01:
        return Sentences::tr("read coils");
    case 0x03:
        return Sentences::tr("read");
    case 0x06:
    case 0x10:
        return Sentences::tr("write");
    default:
        return Sentences::tr("function %1").arg(code);
    }
}

QString malformedWords(const QString& what)
{
    if (what == QStringLiteral("short"))
        return Sentences::tr("cut short");
    if (what == QStringLiteral("length"))
        return Sentences::tr("wrong length");
    if (what == QStringLiteral("function"))
        return Sentences::tr("the answer to another request");
    if (what == QStringLiteral("echo"))
        return Sentences::tr("its echo differs from the request");
    if (what == QStringLiteral("empty"))
        return Sentences::tr("an empty message");
    if (what == QStringLiteral("transaction"))
        return Sentences::tr("an answer that came too late or that nothing asked for");
    if (what == QStringLiteral("unit"))
        return Sentences::tr("the answer of another unit");
    if (what == QStringLiteral("header"))
        return Sentences::tr("no Modbus TCP message");
    if (what == QStringLiteral("noise"))
        return Sentences::tr("a broken message or noise on the line");
    if (what == QStringLiteral("late"))
        return Sentences::tr("an answer that came too late");
    if (what == QStringLiteral("trailing"))
        return Sentences::tr("an answer with more bytes behind it");
    return what.isEmpty() ? Sentences::tr("not readable") : what;
}

QString withValues(const QString& sentence, const QString& values)
{
    return values.isEmpty() ? sentence : sentence + QStringLiteral(": ") + values;
}

} // namespace

QString exceptionWords(int code)
{
    switch (code) {
    case 0x01:
        return Sentences::tr("function not supported");
    case 0x02:
        return Sentences::tr("no such address");
    case 0x03:
        return Sentences::tr("value out of range or inconsistent");
    case 0x04:
        return Sentences::tr("not ready, or the write failed");
    default:
        return Sentences::tr("error %1").arg(code);
    }
}

QString frameSentence(const ports::Frame& frame)
{
    const QString first = frame.arguments.value(0);
    switch (frame.meaning) {
    case ports::FrameMeaning::Connecting:
        return Sentences::tr("connect to %1, port %2").arg(first, frame.arguments.value(1));
    case ports::FrameMeaning::Connected:
        return Sentences::tr("connected");
    case ports::FrameMeaning::Disconnected:
        return first.isEmpty() ? Sentences::tr("disconnected") : Sentences::tr("disconnected: %1").arg(first);
    case ports::FrameMeaning::Read:
        return Sentences::tr("read %1").arg(span(frame));
    case ports::FrameMeaning::ReadCoils:
        return Sentences::tr("read coils %1").arg(span(frame));
    case ports::FrameMeaning::Write:
        return withValues(Sentences::tr("write %1").arg(span(frame)), frame.arguments.value(2));
    case ports::FrameMeaning::Answer:
        return withValues(Sentences::tr("values of %1").arg(span(frame)), frame.arguments.value(2));
    case ports::FrameMeaning::AnswerCoils:
        return withValues(Sentences::tr("coils %1").arg(span(frame)), frame.arguments.value(2));
    case ports::FrameMeaning::Written:
        return Sentences::tr("written %1").arg(span(frame));
    case ports::FrameMeaning::Refused: {
        const int code = numberOf(frame.arguments.value(1));
        return Sentences::tr("refused: %1 (%2, error %3)")
            .arg(exceptionWords(code), functionWords(numberOf(first)),
                 QStringLiteral("%1").arg(code, 2, 16, QLatin1Char('0')).toUpper());
    }
    case ports::FrameMeaning::NoAnswer:
        return first.isEmpty() ? Sentences::tr("no answer")
                               : Sentences::tr("no answer within %1 ms").arg(first);
    case ports::FrameMeaning::Malformed:
        return Sentences::tr("not understood: %1").arg(malformedWords(first));
    case ports::FrameMeaning::Unknown:
        return Sentences::tr("unknown message");
    }
    return {};
}

} // namespace lds::ui

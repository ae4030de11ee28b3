#include "message_details.h"

#include "message_delegates.h"
#include "message_text.h"
#include "sentences.h"
#include "theme.h"

namespace lds::ui {

namespace {

QString span(const QString& text, ColorRole role, const QString& style = {})
{
    return QStringLiteral("<span style=\"color:%1;%2\">%3</span>")
        .arg(color(role).name(), style, text.toHtmlEscaped());
}

QString bytesLine(const ports::Frame& frame)
{
    const QString hex = hexText(frame.bytes);
    const auto dimmed = qsizetype(frame.reconstructedPrefix) * 3;
    const QString family =
        QStringLiteral("font-family:'%1'").arg(bytesFont().families().join(QStringLiteral("','")));
    return span(hex.left(dimmed), ColorRole::DisplayDim, family) +
           span(hex.mid(dimmed), ColorRole::Text, family);
}

} // namespace

MessageDetails::MessageDetails(QWidget* parent)
    : QTextEdit(parent)
{
    setReadOnly(true);
    setFrameShape(QFrame::NoFrame);
    setTabChangesFocus(true);
    setMinimumHeight(64);
    setStyleSheet(
        QStringLiteral("QTextEdit { border: none; border-top: 1px solid palette(mid); border-radius: 0; }"));
    document()->setDocumentMargin(2 * Theme::unit);
    setAccessibleName(tr("Selected message"));
    clear();
}

void MessageDetails::show(const ports::Frame& frame)
{
    QStringList head{messageTime(frame), directionWord(frame.direction)};
    if (frame.roundTripNs >= 0)
        head += tr("%1 ms round trip").arg(roundTripText(frame));
    head += frame.protocol;
    head += frame.peer;
    head.removeAll(QString());
    QStringList lines{span(head.join(QStringLiteral(" · ")), ColorRole::Muted),
                      span(frameSentence(frame), ColorRole::Text)};
    if (!frame.bytes.isEmpty()) {
        lines += bytesLine(frame);
        const QString note = reconstructedNote(frame);
        lines += span(tr("%1 bytes.").arg(frame.bytes.size()) +
                          (note.isEmpty() ? QString() : QLatin1Char(' ') + note),
                      ColorRole::Muted);
    }
    setHtml(lines.join(QStringLiteral("<br>")));
}

void MessageDetails::clear()
{
    setHtml(span(tr("Select a message to see all of it, with every byte. Dimmed bytes are a header that was "
                    "not seen but reconstructed."),
                 ColorRole::Muted));
}

QSize MessageDetails::sizeHint() const { return {200, 96}; }

} // namespace lds::ui

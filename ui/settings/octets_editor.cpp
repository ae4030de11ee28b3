#include "octets_editor.h"

#include "editor_message.h"
#include "item_text.h"
#include "row_facts.h"
#include "sentences.h"
#include "theme.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QRegularExpression>

namespace lds::ui {

namespace {

constexpr int digitsInOctet = 3;

/// Whatever a keyboard or a clipboard gives for the point between two octets.
bool isPoint(QChar c) { return c == u'.' || c == u',' || c == QChar(0x3002) || c == QChar(0xff0e); }

} // namespace

OctetsEditor::OctetsEditor(const SettingRow& row, sensor::SensorSession& session, QWidget* parent)
    : QFrame(parent)
    , RowEditor(row, session)
    , m_message(new EditorMessage(*this))
{
    setAutoFillBackground(true);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(Theme::unit, 1, Theme::unit, 1);
    layout->setSpacing(0);
    for (int octet = 0; octet < fieldCount; ++octet) {
        if (octet > 0)
            layout->addWidget(new QLabel(QStringLiteral("."), this));
        auto* field = new QLineEdit(this);
        m_fields.at(std::size_t(octet)) = field;
        field->setFrame(false);
        field->setAlignment(Qt::AlignHCenter);
        field->setStyleSheet(QStringLiteral("QLineEdit { border: none; padding: 0; min-height: 0; }"));
        field->setAccessibleName(itemName(*row.items.at(octet)));
        field->installEventFilter(this);
        layout->addWidget(field);
        if (const auto value = RowFacts(row, session).wanted(*row.items.at(octet)))
            field->setText(QString::number(*value));
        connect(field, &QLineEdit::textChanged, this, &OctetsEditor::review);
        connect(field, &QLineEdit::textEdited, this, [this, octet](const QString& text) {
            if (text.size() == digitsInOctet && octet + 1 < fieldCount && isAcceptable())
                enterField(octet + 1);
        });
    }
    setFocusProxy(field(0));
    setAccessibleName(row.title());
    m_original = text();
}

QString OctetsEditor::text() const
{
    QStringList parts;
    for (const auto* field : m_fields)
        parts += field->text();
    return parts.join(u'.');
}

void OctetsEditor::restore(const QString& text)
{
    const QStringList parts = text.split(u'.');
    for (int octet = 0; octet < fieldCount; ++octet)
        field(octet)->setText(parts.value(octet));
}

tl::expected<settings::Write, QString> OctetsEditor::parsed() const
{
    settings::Write write;
    for (int octet = 0; octet < fieldCount; ++octet) {
        const auto& item = *row().items.at(octet);
        const QString text = field(octet)->text();
        const auto value = settings::parseValue(item, session()->model(), text);
        if (!value)
            return tl::make_unexpected(parseFailureSentence(item, session()->model(), value.error(), text));
        write.append({item.id, value->effective});
    }
    return write;
}

QString OctetsEditor::error() const
{
    if (!session() || text() == m_original)
        return {};
    const auto write = parsed();
    return write ? QString() : write.error();
}

void OctetsEditor::commit()
{
    if (!session() || text() == m_original)
        return;
    if (const auto write = parsed())
        session()->edit(*write);
}

void OctetsEditor::insist()
{
    for (int octet = 0; octet < fieldCount; ++octet) {
        if (!settings::parseValue(*row().items.at(octet), session()->model(), field(octet)->text())) {
            enterField(octet);
            break;
        }
    }
    review();
}

void OctetsEditor::review()
{
    if (!session())
        return;
    const QString wrong = error();
    QString rules;
    if (wrong.isEmpty() && text() != m_original) {
        if (const auto write = parsed())
            rules = brokenRules(*write);
    }
    if (!wrong.isEmpty())
        m_message->setMessage(EditorMessage::Kind::Error, wrong);
    else
        m_message->setMessage(EditorMessage::Kind::Warning, rules);
    update();
}

void OctetsEditor::enterField(int octet, bool atEnd)
{
    QLineEdit* next = field(octet);
    next->setFocus(Qt::TabFocusReason);
    if (atEnd)
        next->end(false);
    else
        next->selectAll();
}

bool OctetsEditor::eventFilter(QObject* watched, QEvent* event)
{
    int octet = 0;
    while (octet < fieldCount && field(octet) != watched)
        ++octet;
    if (octet == fieldCount)
        return QFrame::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress)
        return keyPressed(octet, *static_cast<QKeyEvent*>(event));
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
        update();
    // The delegate watches this widget, not the fields: leaving all of them is leaving it.
    if (event->type() == QEvent::FocusOut && !isAncestorOf(QApplication::focusWidget())) {
        QFocusEvent out(QEvent::FocusOut, static_cast<QFocusEvent*>(event)->reason());
        QApplication::sendEvent(this, &out);
    }
    return false;
}

bool OctetsEditor::keyPressed(int octet, const QKeyEvent& event)
{
    QLineEdit* here = field(octet);
    const bool first = octet == 0;
    const bool last = octet + 1 == fieldCount;
    if (event.matches(QKeySequence::Paste))
        return pasteAddress(QApplication::clipboard()->text());
    if (!event.text().isEmpty() && isPoint(event.text().at(0))) {
        if (!last && !here->text().isEmpty() && !here->hasSelectedText())
            enterField(octet + 1);
        return true; // a point never belongs into a field
    }
    switch (event.key()) {
    case Qt::Key_Left:
        if (first || here->cursorPosition() > 0 || event.modifiers() != Qt::NoModifier)
            return false;
        enterField(octet - 1, true);
        return true;
    case Qt::Key_Right:
        if (last || here->cursorPosition() < here->text().size() || event.modifiers() != Qt::NoModifier)
            return false;
        enterField(octet + 1);
        return true;
    case Qt::Key_Backspace:
        if (first || here->cursorPosition() > 0 || here->hasSelectedText())
            return false;
        enterField(octet - 1, true);
        return true;
    case Qt::Key_Tab:
    case Qt::Key_Backtab:
        if (event.key() == Qt::Key_Tab ? !last : !first) {
            enterField(event.key() == Qt::Key_Tab ? octet + 1 : octet - 1);
        } else {
            QKeyEvent forwarded(QEvent::KeyPress, event.key(), event.modifiers());
            QApplication::sendEvent(this, &forwarded);
        }
        return true;
    default:
        return false;
    }
}

bool OctetsEditor::pasteAddress(const QString& text)
{
    static const QRegularExpression address(
        QStringLiteral("^\\s*(\\d{1,3})\\.(\\d{1,3})\\.(\\d{1,3})\\.(\\d{1,3})\\s*(/\\d+)?\\s*$"));
    const auto match = address.match(text.normalized(QString::NormalizationForm_KC));
    if (!match.hasMatch())
        return false; // a piece of an address goes into the field, as in any other
    for (int octet = 0; octet < fieldCount; ++octet)
        field(octet)->setText(match.captured(octet + 1));
    enterField(fieldCount - 1, true);
    return true;
}

QSize OctetsEditor::sizeHint() const
{
    const int octetWidth = fontMetrics().horizontalAdvance(QStringLiteral("0000")) + Theme::unit;
    const int pointWidth = fontMetrics().horizontalAdvance(u'.');
    return {fieldCount * octetWidth + (fieldCount - 1) * pointWidth + 2 * Theme::unit + 2, 26};
}

void OctetsEditor::paintEvent(QPaintEvent*)
{
    const bool focused = isAncestorOf(QApplication::focusWidget());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(color(!isAcceptable() ? ColorRole::Error : focused ? ColorRole::Accent : ColorRole::Line));
    painter.setBrush(color(ColorRole::Panel));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
}

} // namespace lds::ui

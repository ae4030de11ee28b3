#include "number_editor.h"

#include "editor_message.h"
#include "item_text.h"
#include "row_facts.h"
#include "sentences.h"

#include <algorithm>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStyle>

namespace lds::ui {

NumberEditor::NumberEditor(const SettingRow& row, sensor::SensorSession& session, QWidget* parent)
    : QAbstractSpinBox(parent)
    , RowEditor(row, session)
    , m_message(new EditorMessage(*this))
{
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setAccessibleName(row.title());
    setKeyboardTracking(true);
    if (const auto value = RowFacts(row, session).wanted(item()))
        setValue(*value);
    m_original = text();
    connect(lineEdit(), &QLineEdit::textChanged, this, &NumberEditor::review);
}

QString NumberEditor::text() const { return lineEdit()->text(); }

void NumberEditor::restore(const QString& text)
{
    lineEdit()->setText(text);
    lineEdit()->selectAll();
}

NumberEditor::Parsed NumberEditor::parsed() const
{
    return settings::parseValue(item(), session()->model(), text());
}

QString NumberEditor::error() const
{
    if (!session() || text() == m_original)
        return {};
    const auto value = parsed();
    return value ? QString() : parseFailureSentence(item(), session()->model(), value.error(), text());
}

void NumberEditor::commit()
{
    if (session() && text() != m_original)
        session()->editText(item().id, text());
}

void NumberEditor::insist()
{
    setFocus(Qt::OtherFocusReason);
    lineEdit()->selectAll();
    review();
}

void NumberEditor::review()
{
    if (!session())
        return;
    const QString wrong = error();
    setProperty("invalid", !wrong.isEmpty());
    style()->unpolish(this);
    style()->polish(this);
    if (!wrong.isEmpty()) {
        m_message->setMessage(EditorMessage::Kind::Error, wrong);
        return;
    }
    const auto value = parsed();
    if (!value || text() == m_original) {
        m_message->setMessage(EditorMessage::Kind::Note, {});
        return;
    }
    QStringList sentences;
    if (value->effective != value->written)
        sentences += tr("The sensor will round it down to %1.")
                         .arg(displayValueWithUnit(item(), session()->model(), value->effective));
    const QString rules = brokenRules({{item().id, value->effective}});
    if (!rules.isEmpty())
        sentences += rules;
    m_message->setMessage(rules.isEmpty() ? EditorMessage::Kind::Note : EditorMessage::Kind::Warning,
                          sentences.join(u' '));
}

void NumberEditor::setValue(catalog::Value value)
{
    lineEdit()->setText(displayValue(item(), session()->model(), value));
}

void NumberEditor::stepBy(int steps)
{
    const auto value = session() ? parsed() : Parsed(tl::make_unexpected(settings::ParseFailure{}));
    if (!value)
        return;
    const auto& limits = item().limitsFor(session()->model());
    const qint64 wanted = value->effective + qint64(steps) * limits.resolution;
    setValue(catalog::Value(std::clamp<qint64>(wanted, limits.minimum, limits.maximum)));
    lineEdit()->selectAll();
}

QAbstractSpinBox::StepEnabled NumberEditor::stepEnabled() const
{
    StepEnabled enabled;
    const auto value = session() ? parsed() : Parsed(tl::make_unexpected(settings::ParseFailure{}));
    if (!value)
        return enabled;
    const auto& limits = item().limitsFor(session()->model());
    enabled.setFlag(StepUpEnabled, value->effective < limits.maximum);
    enabled.setFlag(StepDownEnabled, value->effective > limits.minimum);
    return enabled;
}

// What is typed is judged by review() and commit(); a half-typed number must never be kept out.
QValidator::State NumberEditor::validate(QString&, int&) const { return QValidator::Acceptable; }

void NumberEditor::keyPressEvent(QKeyEvent* event)
{
    const bool page = event->key() == Qt::Key_PageUp || event->key() == Qt::Key_PageDown;
    if (!page) {
        QAbstractSpinBox::keyPressEvent(event);
        return;
    }
    const bool wide = event->modifiers().testAnyFlags(Qt::ShiftModifier | Qt::ControlModifier);
    const int steps = wide ? 100 : 10;
    stepBy(event->key() == Qt::Key_PageUp ? steps : -steps);
    event->accept();
}

} // namespace lds::ui

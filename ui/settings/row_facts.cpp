#include "row_facts.h"

#include "item_text.h"
#include "sentences.h"

#include <algorithm>
#include <QCoreApplication>

namespace lds::ui {

using catalog::Kind;
using catalog::SettingItem;
using catalog::Value;

namespace {

QString say(const char* text) { return QCoreApplication::translate("SettingsPage", text); }

QString protocolName(ports::Protocol protocol)
{
    switch (protocol) {
    case ports::Protocol::ModbusTcp:
    case ports::Protocol::ModbusRtu:
        return QStringLiteral("Modbus");
    }
    return {};
}

} // namespace

bool RowFacts::isKnown() const
{
    return !m_row.isHeading() &&
           std::all_of(m_row.items.begin(), m_row.items.end(),
                       [this](const auto* item) { return m_session.held(item->id).has_value(); });
}

QString RowFacts::heldText() const
{
    if (!isKnown())
        return {};
    QList<Value> values;
    for (const auto* item : m_row.items)
        values.append(*m_session.held(item->id));
    return text(values);
}

QString RowFacts::missingWord() const
{
    if (m_row.isHeading() || isKnown())
        return {};
    const SettingItem& item = *m_row.first();
    const bool everConnected = !m_session.heldValues().isEmpty();
    const bool hasAddress = item.modbus || item.slmp || item.eip;
    if ((everConnected || !hasAddress) && !m_session.reaches(item.id))
        return say(QT_TRANSLATE_NOOP("SettingsPage", "not reachable over %1"))
            .arg(protocolName(m_session.url().protocol));
    return item.isReadable() ? say(QT_TRANSLATE_NOOP("SettingsPage", "not read yet")) : QString();
}

bool RowFacts::isEdited() const
{
    return std::any_of(m_row.items.begin(), m_row.items.end(),
                       [this](const auto* item) { return m_session.pending().find(item->id).has_value(); });
}

bool RowFacts::hasConflict() const
{
    return std::any_of(m_row.items.begin(), m_row.items.end(), [this](const auto* item) {
        const auto edit = m_session.pending().find(item->id);
        return edit && edit->conflict;
    });
}

std::optional<Value> RowFacts::wanted(const SettingItem& item) const
{
    if (const auto edit = m_session.pending().find(item.id))
        return edit->wanted;
    return m_session.held(item.id);
}

QString RowFacts::wantedText() const
{
    QList<Value> values;
    for (const auto* item : m_row.items) {
        const auto value = wanted(*item);
        if (!value)
            return {};
        values.append(*value);
    }
    return text(values);
}

QString RowFacts::baseText() const
{
    QList<Value> values;
    for (const auto* item : m_row.items) {
        const auto edit = m_session.pending().find(item->id);
        const auto value = edit ? std::optional<Value>(edit->base) : m_session.held(item->id);
        if (!value)
            return {};
        values.append(*value);
    }
    return text(values);
}

QStringList RowFacts::problemSentences(const QList<settings::Refusal>& problems) const
{
    return problems.isEmpty() ? QStringList() : problemSentences(problems, wantedValues(m_session));
}

QStringList RowFacts::problemSentences(const QList<settings::Refusal>& problems,
                                       const settings::Values& state) const
{
    QStringList sentences;
    const auto ids = m_row.ids();
    for (const auto& problem : problems) {
        const bool ours = std::any_of(problem.items.begin(), problem.items.end(),
                                      [&ids](catalog::ItemId id) { return ids.contains(id); });
        if (!ours)
            continue;
        const QString sentence = refusalSentence(problem, m_session.model(), state);
        if (!sentences.contains(sentence))
            sentences.append(sentence);
    }
    return sentences;
}

QString RowFacts::unit() const { return m_row.first() ? settings::unitText(*m_row.first()) : QString(); }

QString RowFacts::range() const
{
    if (m_row.isHeading())
        return {};
    if (m_row.shape == SettingRow::Shape::Octets) {
        QList<Value> lowest;
        QList<Value> highest;
        for (const auto* item : m_row.items) {
            lowest.append(item->limitsFor(m_session.model()).minimum);
            highest.append(item->limitsFor(m_session.model()).maximum);
        }
        return octetsText(lowest) + QStringLiteral(" … ") + octetsText(highest);
    }
    QList<QString> parts;
    for (const auto* item : m_row.items)
        parts.append(rangeText(*item, m_session.model()));
    return joined(parts);
}

bool RowFacts::hasDefault() const
{
    return !m_row.isHeading() && std::all_of(m_row.items.begin(), m_row.items.end(),
                                             [](const auto* item) { return item->hasDefault; });
}

QString RowFacts::defaultText() const
{
    if (!hasDefault())
        return {};
    if (m_row.shape != SettingRow::Shape::Octets) {
        QList<QString> parts;
        for (const auto* item : m_row.items)
            parts.append(ui::defaultText(*item, m_session.model()));
        return joined(parts);
    }
    QList<Value> octets;
    for (const auto& value : defaults())
        octets.append(value.value);
    return octetsText(octets);
}

settings::Write RowFacts::defaults() const
{
    settings::Write write;
    for (const auto* item : m_row.items)
        write.append({item->id, item->limitsFor(m_session.model()).defaultValue});
    return write;
}

bool RowFacts::isNumber() const
{
    if (m_row.isHeading())
        return false;
    const Kind kind = m_row.first()->kind;
    return kind != Kind::Choice && kind != Kind::Trigger && kind != Kind::Bits && kind != Kind::MacAddress;
}

QString RowFacts::whyNot() const
{
    if (m_row.isHeading())
        return {};
    if (const QString reason = unreachableReason(*m_row.first(), m_session); !reason.isEmpty())
        return reason;
    if (m_row.isSetting() && !isKnown())
        return say(QT_TRANSLATE_NOOP("SettingsPage", "It has not been read from the sensor yet."));
    if (!m_row.actsAtOnce() || isUsable())
        return {};
    if (m_session.isStale())
        return say(
            QT_TRANSLATE_NOOP("SettingsPage", "It acts at once, so it needs the sensor to be connected."));
    if (m_session.isRunning() || m_session.isApplying())
        return say(QT_TRANSLATE_NOOP("SettingsPage", "Wait until what is under way has ended."));
    return say(QT_TRANSLATE_NOOP(
        "SettingsPage", "The sensor takes no orders now: it is in its menu, or busy with something else."));
}

bool RowFacts::isEditable() const
{
    return m_row.isSetting() && m_row.first()->isWritable() && isKnown() &&
           m_session.reaches(m_row.first()->id) && !m_session.isViewOnly();
}

bool RowFacts::isUsable() const
{
    return m_row.actsAtOnce() && m_row.first()->isWritable() && m_session.reaches(m_row.first()->id) &&
           m_session.canWrite() && !m_session.isRunning() && !m_session.isApplying();
}

settings::Values RowFacts::wantedValues(const sensor::SensorSession& session)
{
    settings::Values values = session.heldValues();
    const auto& edits = session.pending().edits();
    for (auto it = edits.begin(); it != edits.end(); ++it)
        values.insert(it.key(), it->wanted);
    return values;
}

QString RowFacts::joined(const QList<QString>& parts) const
{
    const bool allAlike = std::all_of(parts.begin(), parts.end(),
                                      [&parts](const QString& part) { return part == parts.constFirst(); });
    return allAlike && !parts.isEmpty() ? parts.constFirst() : QStringList(parts).join(QStringLiteral(" / "));
}

QString RowFacts::text(const QList<Value>& values) const
{
    if (m_row.shape == SettingRow::Shape::Octets)
        return octetsText(values);
    QStringList parts;
    for (qsizetype i = 0; i < values.size(); ++i)
        parts.append(displayValue(*m_row.items.at(i), m_session.model(), values.at(i)));
    return parts.join(QStringLiteral(" / "));
}

} // namespace lds::ui

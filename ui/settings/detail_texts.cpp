#include "detail_texts.h"

#include "item_text.h"
#include "row_facts.h"

#include <algorithm>
#include <QCoreApplication>

namespace lds::ui::detail_texts {

using catalog::Effect;
using catalog::Kind;
using catalog::Role;
using catalog::Scope;
using catalog::SettingItem;

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::DetailTexts)
};

QString withUnit(const QString& value, const QString& unit)
{
    return value.isEmpty() || unit.isEmpty() ? value : value + QChar(QChar::Nbsp) + unit;
}

QString strong(const QString& text) { return QStringLiteral("<b>%1</b>").arg(text.toHtmlEscaped()); }

QString resolution(const SettingItem& item, catalog::SensorModel model)
{
    const auto step = item.limitsFor(model).resolution;
    if (item.kind == Kind::Length)
        return Texts::tr("Resolution %1 µm; the sensor rounds further digits down.")
            .arg(step % 10 ? QString::number(step / 10) + u'.' + QString::number(step % 10)
                           : QString::number(step / 10));
    return item.kind == Kind::Factor ? Texts::tr("Four decimals.") : QString();
}

QString scope(const SettingItem& item)
{
    return item.scope == Scope::Bank ? Texts::tr("Kept per bank.") : Texts::tr("Common to all banks.");
}

QString effect(const SettingItem& item)
{
    if (item.role == Role::Setting && item.effect == Effect::AfterCommunicationReset)
        return Texts::tr("Takes effect after a communication reset (menu 95) or a restart.");
    return item.role == Role::Setting ? Texts::tr("Takes effect when it is applied.") : QString();
}

} // namespace

QString path(const SettingRow& row)
{
    QStringList parts;
    if (row.menu)
        parts += Texts::tr("Menu %1").arg(row.menu);
    for (const SettingRow* above = row.parent; above; above = above->parent)
        parts.insert(row.menu ? 1 : 0, above->title());
    return parts.join(QStringLiteral(" · "));
}

QString help(const SettingRow& row)
{
    if (row.shape != SettingRow::Shape::Several)
        return row.first() ? itemHelp(*row.first()) : QString();
    QStringList parts;
    for (const auto* item : row.items)
        parts += Texts::tr("%1: %2").arg(itemName(*item), itemHelp(*item));
    return parts.join(QStringLiteral("\n\n"));
}

QStringList change(const SettingRow& row, const sensor::SensorSession& session)
{
    const RowFacts facts(row, session);
    const SettingItem& item = *row.first();
    QStringList lines;
    if (facts.isEdited()) {
        lines += Texts::tr("%1 → %2").arg(facts.heldText().toHtmlEscaped(),
                                          strong(withUnit(facts.wantedText(), facts.unit())));
    } else if (facts.isKnown()) {
        lines += (facts.isStale() ? Texts::tr("Last known: %1") : Texts::tr("In the sensor: %1"))
                     .arg(strong(withUnit(facts.heldText(), facts.unit())));
    }
    if (row.actsAtOnce() && item.role != Role::Procedure)
        lines += Texts::tr("Acts at once, without Apply; it is not part of the pending changes.");
    QStringList notes{resolution(item, session.model())};
    if (item.role == Role::Setting || item.isReadable())
        notes += scope(item);
    notes += effect(item);
    notes.removeAll(QString());
    if (!notes.isEmpty())
        lines += notes.join(u' ').toHtmlEscaped();
    return lines;
}

QStringList rangeAndDefault(const SettingRow& row, const sensor::SensorSession& session)
{
    const RowFacts facts(row, session);
    QStringList lines;
    if (row.shape == SettingRow::Shape::Single && row.first()->kind == Kind::Choice) {
        QStringList names; // all of them: here is the room the column does not have
        for (const auto& choice : row.first()->choices) {
            if (choice.models & catalog::maskOf(session.model()))
                names += choiceName(choice);
        }
        lines += names.join(QStringLiteral(", ")).toHtmlEscaped();
    } else if (!facts.range().isEmpty()) {
        lines += withUnit(facts.range(), facts.unit()).toHtmlEscaped();
    }
    if (!facts.defaultText().isEmpty())
        lines += Texts::tr("Default %1").arg(withUnit(facts.defaultText(), facts.unit())).toHtmlEscaped();
    return lines;
}

QStringList addresses(const SettingRow& row)
{
    if (row.shape != SettingRow::Shape::Octets) {
        QStringList lines;
        for (const auto* item : row.items)
            lines += addressTexts(*item);
        return lines;
    }
    QList<int> numbers;
    for (const auto* item : row.items) {
        if (item->modbus)
            numbers += item->modbus->number;
    }
    if (numbers.isEmpty())
        return {};
    const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
    return {Texts::tr("Modbus %1 – %2, one number each").arg(*least).arg(*most)};
}

QString manual(const SettingRow& row)
{
    const char* section = row.entry ? row.entry->section : row.first() ? row.first()->section : nullptr;
    return section ? Texts::tr("Manual §%1").arg(QString::fromLatin1(section)) : QString();
}

QString conflict(const SettingRow& row, const sensor::SensorSession& session)
{
    const RowFacts facts(row, session);
    return Texts::tr("The sensor's value has changed from %1 to %2 since this edit was made. "
                     "Your value is %3. Which one is to stay?")
        .arg(withUnit(facts.baseText(), facts.unit()), withUnit(facts.heldText(), facts.unit()),
             withUnit(facts.wantedText(), facts.unit()));
}

} // namespace lds::ui::detail_texts

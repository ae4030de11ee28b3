#include "assignment.h"

#include "sentences.h"
#include "texts.h"
#include "value_text.h"

#include <QSet>

namespace lds::ctl {

namespace {

using catalog::SettingItem;

QString whyNotSettable(const Target& target)
{
    const SettingItem& item = catalog::hlG2(target.items.first());
    if (item.isWritable())
        return {};
    if (item.role == catalog::Role::Status)
        return Texts::tr("%1 cannot be set: the sensor reports it. Read it with “read”.").arg(target.key);
    return Texts::tr("%1 cannot be set: no protocol has an address for it. Use the sensor's keys, menu %2.")
        .arg(target.key)
        .arg(item.menu);
}

/// "ON (Emission stopped)" answers to "on" as well.
bool choiceAnswersTo(const catalog::Choice& choice, const QString& text)
{
    const QString name = QString::fromUtf8(choice.name);
    return name.compare(text, Qt::CaseInsensitive) == 0 ||
           name.section(QStringLiteral(" ("), 0, 0).compare(text, Qt::CaseInsensitive) == 0;
}

/// A choice's name becomes its code; everything else stays as it is.
QString withoutChoiceName(const SettingItem& item, catalog::SensorModel model, const QString& text)
{
    for (const catalog::Choice& choice : item.choices) {
        if ((choice.models & catalog::maskOf(model)) && choiceAnswersTo(choice, text.trimmed()))
            return QString::number(choice.code);
    }
    return text;
}

QString choicesText(const SettingItem& item, catalog::SensorModel model)
{
    QStringList names;
    for (const catalog::Choice& choice : item.choices) {
        if (choice.models & catalog::maskOf(model))
            names += QStringLiteral("%1 = %2").arg(choice.code).arg(QString::fromUtf8(choice.name));
    }
    return names.join(QStringLiteral(", "));
}

tl::expected<WantedValue, QString> readOne(const SettingItem& item, const QString& text, const QString& typed,
                                           catalog::SensorModel model)
{
    const auto parsed = settings::parseValue(item, model, withoutChoiceName(item, model, text));
    if (parsed)
        return WantedValue{item.id, parsed->written, parsed->effective};
    const QString where = QString::fromLatin1(item.key) + u'=' + typed;
    if (item.kind == catalog::Kind::Choice)
        return tl::unexpected(Texts::tr("%1: choose one of %2.").arg(where, choicesText(item, model)));
    if (item.kind == catalog::Kind::Trigger)
        return tl::unexpected(Texts::tr("%1: only 0 executes it.").arg(where));
    return tl::unexpected(where + QStringLiteral(": ") +
                          ui::parseFailureSentence(item, model, parsed.error(), typed));
}

} // namespace

tl::expected<QList<Assignment>, QString> parseAssignments(const QStringList& arguments)
{
    QList<Assignment> assignments;
    QSet<catalog::ItemId> seen;
    for (const QString& argument : arguments) {
        const qsizetype equals = argument.indexOf(u'=');
        if (equals <= 0)
            return tl::unexpected(
                Texts::tr("“%1” is not KEY=VALUE, such as highSetValue=1.75.").arg(argument));
        const QString key = argument.first(equals);
        const std::optional<Target> target = findTarget(key);
        if (!target)
            return tl::unexpected(unknownKeyMessage(key));
        if (const QString reason = whyNotSettable(*target); !reason.isEmpty())
            return tl::unexpected(reason);
        for (const catalog::ItemId item : target->items) {
            if (seen.contains(item))
                return tl::unexpected(Texts::tr("%1 is set more than once; give it one value.").arg(key));
            seen.insert(item);
        }
        assignments.append({*target, argument.sliced(equals + 1)});
    }
    return assignments;
}

tl::expected<QList<WantedValue>, QString> readValues(const Assignment& assignment, catalog::SensorModel model)
{
    const QList<catalog::ItemId>& items = assignment.target.items;
    const QStringList parts =
        assignment.target.isGroup() ? assignment.text.trimmed().split(u'.') : QStringList{assignment.text};
    if (parts.size() != items.size()) {
        return tl::unexpected(Texts::tr("%1=%2: expected four numbers, such as 192.168.1.7.")
                                  .arg(assignment.target.key, assignment.text));
    }
    QList<WantedValue> values;
    for (qsizetype part = 0; part < parts.size(); ++part) {
        const auto value = readOne(catalog::hlG2(items[part]), parts[part], parts[part], model);
        if (!value)
            return tl::unexpected(value.error());
        values.append(*value);
    }
    return values;
}

} // namespace lds::ctl

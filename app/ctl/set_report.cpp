#include "set_report.h"

#include "console.h"
#include "texts.h"
#include "value_report.h"

#include <algorithm>

namespace lds::ctl {

namespace {

QString statusKey(SetStatus status)
{
    switch (status) {
    case SetStatus::NotTried:
        return QStringLiteral("notTried");
    case SetStatus::Unchanged:
        return QStringLiteral("unchanged");
    case SetStatus::Done:
        return QStringLiteral("done");
    case SetStatus::Different:
        return QStringLiteral("different");
    case SetStatus::Refused:
        return QStringLiteral("refused");
    case SetStatus::Unknown:
        return QStringLiteral("unknown");
    }
    return {};
}

QString statusWords(SetStatus status)
{
    switch (status) {
    case SetStatus::NotTried:
        return Texts::tr("not tried");
    case SetStatus::Unchanged:
        return Texts::tr("was so already");
    case SetStatus::Done:
        return Texts::tr("done");
    case SetStatus::Different:
        return Texts::tr("the sensor holds another value");
    case SetStatus::Refused:
        return Texts::tr("refused");
    case SetStatus::Unknown:
        return Texts::tr("not known: no answer");
    }
    return {};
}

QString savedKey(sensor::Saved saved)
{
    switch (saved) {
    case sensor::Saved::Unknown:
        return QStringLiteral("unknown");
    case sensor::Saved::Saved:
        return QStringLiteral("saved");
    case sensor::Saved::NotSaved:
        return QStringLiteral("notSaved");
    }
    return {};
}

bool isReadable(const Target& target) { return catalog::hlG2(target.items.first()).isReadable(); }

} // namespace

SetResult* SetReport::find(catalog::ItemId item)
{
    const auto found = std::ranges::find_if(
        m_results, [item](const SetResult& result) { return result.target.items.contains(item); });
    return found == m_results.end() ? nullptr : &*found;
}

void SetReport::noteBefore(catalog::ItemId item, const settings::Values& held)
{
    SetResult* result = find(item);
    if (result && held.contains(item))
        result->before.insert(item, held.value(item));
}

void SetReport::mark(catalog::ItemId item, SetStatus status)
{
    if (SetResult* result = find(item))
        result->status = std::max(result->status, status);
}

void SetReport::markApplied(const sensor::ApplyReport& report, const QList<catalog::ItemId>& asked)
{
    const auto markAll = [this, &asked](const QList<sensor::WriteResult>& writes, SetStatus status) {
        for (const sensor::WriteResult& result : writes) {
            for (const settings::ItemValue& each : result.write) {
                if (asked.contains(each.item))
                    mark(each.item, status);
            }
        }
    };
    markAll(report.written, SetStatus::Done);
    markAll(report.different, SetStatus::Different);
    markAll(report.refused, SetStatus::Refused);
    markAll(report.unknown, SetStatus::Unknown);
}

bool SetReport::wroteASetting() const
{
    return std::ranges::any_of(m_results, [](const SetResult& result) {
        return result.status == SetStatus::Done &&
               catalog::hlG2(result.target.items.first()).role == catalog::Role::Setting;
    });
}

QJsonObject SetReport::toJson(catalog::SensorModel model, const settings::Values& held,
                              sensor::Saved saved) const
{
    QJsonArray results;
    for (const SetResult& result : m_results) {
        results.append(QJsonObject{{QStringLiteral("key"), result.target.key},
                                   {QStringLiteral("status"), statusKey(result.status)},
                                   {QStringLiteral("before"), valueJson(result.target, model, result.before)},
                                   {QStringLiteral("wanted"), valueJson(result.target, model, result.wanted)},
                                   {QStringLiteral("after"), valueJson(result.target, model, held)}});
    }
    return {{QStringLiteral("results"), results}, {QStringLiteral("saved"), savedKey(saved)}};
}

QStringList SetReport::toLines(catalog::SensorModel model, const settings::Values& held) const
{
    QList<QStringList> rows;
    for (const SetResult& result : m_results) {
        QString values;
        if (isReadable(result.target)) {
            const QString unit = unitOf(result.target, held);
            const QString after = valueWords(result.target, model, held);
            values = valueWords(result.target, model, result.before);
            if (after != values)
                values += QStringLiteral(" -> ") + after;
            if (!unit.isEmpty())
                values += u' ' + unit;
        }
        rows += QStringList{result.target.key, values, statusWords(result.status)};
    }
    return alignedLines(rows);
}

} // namespace lds::ctl

#include "apply_summary.h"

#include "item_text.h"
#include "sentences.h"

#include <QCoreApplication>

namespace lds::ui {

using catalog::ItemId;
using sensor::SensorSession;
using sensor::WriteResult;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::ApplySummary)
};

QString valuesText(const settings::Write& write, const settings::Values& values, const SensorSession& session)
{
    QList<catalog::Value> found;
    for (const auto& each : write) {
        if (!values.contains(each.item))
            return QStringLiteral("?");
        found += values.value(each.item);
    }
    if (found.size() == 1)
        return displayValueWithUnit(session.catalog().item(write.first().item), session.model(),
                                    found.first());
    return octetsText(found);
}

QString wantedText(const settings::Write& write, const SensorSession& session)
{
    settings::Values wanted;
    for (const auto& each : write)
        wanted.insert(each.item, each.value);
    return valuesText(write, wanted, session);
}

const catalog::SettingItem* itemOf(const WriteResult& result, const SensorSession& session)
{
    return result.write.isEmpty() ? nullptr : &session.catalog().item(result.write.first().item);
}

QString names(const QList<ItemId>& items, const SensorSession& session)
{
    QStringList texts;
    for (const ItemId id : items) {
        const QString name = writeName({{id, 0}}, session);
        if (!texts.contains(name))
            texts += name;
    }
    return texts.join(QStringLiteral(", "));
}

QString differentSentence(const WriteResult& result, const SensorSession& session)
{
    return Words::tr(
               "%1: the sensor took %2 but holds %3. Check the value, then apply it again or revert it.")
        .arg(writeName(result.write, session), wantedText(result.write, session),
             valuesText(result.write, result.readBack, session));
}

QString unknownSentence(const WriteResult& result, const SensorSession& session)
{
    const QString why = failureSentence(result.failure, itemOf(result, session));
    if (result.readBack.isEmpty())
        return why;
    return Words::tr("%1 Read back, it is %2.").arg(why, valuesText(result.write, result.readBack, session));
}

} // namespace

QString writeName(const settings::Write& write, const SensorSession& session)
{
    if (write.isEmpty())
        return {};
    const auto& item = session.catalog().item(write.first().item);
    const auto* entry = session.catalog().findMenu(item.menu);
    return item.group != catalog::WriteGroup::None && entry ? menuName(*entry) : itemName(item);
}

ApplySummary summarize(const sensor::ApplyReport& report, const SensorSession& session)
{
    ApplySummary summary;
    const int done = int(report.written.size());
    const int failed = int(report.refused.size() + report.different.size() + report.unknown.size());
    if (report.allDone())
        summary.headline = done == 1 ? Words::tr("1 change written and read back.")
                                     : Words::tr("%1 changes written and read back.").arg(done);
    else if (report.planFailure)
        summary.headline = Words::tr("Nothing was written: the values contradict each other.");
    else
        summary.headline = Words::tr("%1 written, %2 not carried out, %3 not tried.")
                               .arg(done)
                               .arg(failed)
                               .arg(report.notTried.size() + report.inConflict.size());

    for (const WriteResult& result : report.refused)
        summary.sentences += failureSentence(result.failure, itemOf(result, session));
    for (const WriteResult& result : report.different)
        summary.sentences += differentSentence(result, session);
    for (const WriteResult& result : report.unknown)
        summary.sentences += unknownSentence(result, session);
    if (report.planFailure) {
        settings::Values goal = session.heldValues();
        goal.insert(session.pending().wantedValues());
        for (const auto& refusal : report.planFailure->refusals)
            summary.sentences += refusalSentence(refusal, session.model(), goal);
    }
    if (!report.inConflict.isEmpty())
        summary.sentences +=
            Words::tr("Not written because the sensor's value has changed meanwhile: %1. Keep "
                      "yours or take the sensor's.")
                .arg(names(report.inConflict, session));
    if (report.connectionLost)
        summary.sentences +=
            Words::tr("The connection was lost on the way. The edits stay; apply again after "
                      "reconnecting.");
    else if (report.cancelled)
        summary.sentences += Words::tr("Stopped on request. The edits not tried stay.");
    if (!report.notTried.isEmpty() && !report.planFailure)
        summary.sentences += Words::tr("Not tried: %1.").arg(names(report.notTried, session));
    if (!report.changedByItself.isEmpty())
        summary.byTheWay = Words::tr("The sensor changed by itself along the way: %1.")
                               .arg(names(report.changedByItself, session));
    return summary;
}

} // namespace lds::ui

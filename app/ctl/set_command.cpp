#include "set_command.h"

#include "console.h"
#include "sentences.h"
#include "texts.h"
#include "value_report.h"

#include <algorithm>

namespace lds::ctl {

using catalog::ItemId;
using catalog::SensorModel;
using sensor::SensorSession;

namespace {

settings::Values overlaid(settings::Values held, const settings::Values& wanted)
{
    held.insert(wanted);
    return held;
}

Target single(ItemId item) { return {QString::fromLatin1(catalog::hlG2(item).key), {item}}; }

} // namespace

bool SetCommand::prepare()
{
    const auto assignments = parseAssignments(line().arguments);
    if (!assignments) {
        console().message(assignments.error());
        finish(ExitCode::Usage);
        return false;
    }
    m_assignments = *assignments;
    if (!proveValues()) {
        finish(ExitCode::Usage);
        return false;
    }
    if (session().isViewOnly()) {
        console().message(Texts::tr("%1 says view=only, which never writes. Leave it out to set values.")
                              .arg(session().url().toString()));
        finish(ExitCode::Refused);
        return false;
    }
    connect(&session(), &SensorSession::applyFinished, this, &SetCommand::onApplyFinished);
    connect(&session(), &SensorSession::commandFinished, this, &SetCommand::onCommandFinished);
    return true;
}

/// A value that no type the sensor may be can have needs no connection to be refused.
bool SetCommand::proveValues()
{
    QList<SensorModel> models;
    for (const catalog::ModelDescription& model : session().catalog().models()) {
        if (!session().modelIsStated() || model.model == session().model())
            models.append(model.model);
    }
    for (const Assignment& assignment : std::as_const(m_assignments)) {
        QString error;
        const bool possible = std::ranges::any_of(models, [&](SensorModel model) {
            const auto values = readValues(assignment, model);
            error = values ? QString() : values.error();
            return values.has_value();
        });
        if (!possible) {
            console().message(error);
            sayWhoseLimits(assignment, models.last());
            return false;
        }
    }
    return true;
}

/// Limits in a message are one type's; which one is taken for granted only when the URL says it.
void SetCommand::sayWhoseLimits(const Assignment& assignment, SensorModel model)
{
    const auto& limits = catalog::hlG2(assignment.target.items.first()).limits;
    const bool differ = std::ranges::any_of(limits, [&](const catalog::Limits& each) {
        return each.minimum != limits.front().minimum || each.maximum != limits.front().maximum;
    });
    if (session().modelIsStated() || !differ)
        return;
    console().message(Texts::tr("These are the limits of the %1; each type has its own. Say which it is with "
                                "?sensor=TYPE in the URL.")
                          .arg(QString::fromLatin1(session().catalog().model(model).typeName)));
}

void SetCommand::onReady()
{
    if (!readAllValues())
        return finish(ExitCode::Usage);
    if (refuseUnreachable() || refuseWhileNotWritable())
        return finish(ExitCode::Refused);
    for (const Step& step : std::as_const(m_steps)) {
        for (const WantedValue& value : step.values)
            sayRounding(value);
    }
    next();
}

bool SetCommand::readAllValues()
{
    for (const Assignment& assignment : std::as_const(m_assignments)) {
        const auto values = readValues(assignment, session().model());
        if (!values) {
            console().message(values.error());
            sayWhoseLimits(assignment, session().model());
            return false;
        }
        SetResult result{assignment.target, {}, {}, SetStatus::NotTried};
        for (const WantedValue& value : *values)
            result.wanted.insert(value.item, value.effective);
        m_report.add(result);
        for (const WantedValue& value : *values)
            m_report.noteBefore(value.item, session().heldValues());
        addStep(*values);
    }
    return true;
}

void SetCommand::addStep(const QList<WantedValue>& values)
{
    const bool isRun = catalog::hlG2(values.first().item).role != catalog::Role::Setting;
    if (isRun || m_steps.isEmpty() || m_steps.last().isRun)
        m_steps.append({values, isRun});
    else
        m_steps.last().values += values;
}

bool SetCommand::refuseUnreachable()
{
    for (const Step& step : std::as_const(m_steps)) {
        for (const WantedValue& value : step.values) {
            if (session().reaches(value.item))
                continue;
            console().message(
                ui::failureSentence({ports::FailureCode::NotReachable, 0, {}}, &catalog::hlG2(value.item)));
            return true;
        }
    }
    return false;
}

bool SetCommand::refuseWhileNotWritable()
{
    if (session().canWrite())
        return false;
    const ports::FailureCode code =
        session().isSensorNotReady() ? ports::FailureCode::NotReady : ports::FailureCode::NotConnected;
    console().message(ui::failureSentence({code, 0, {}}, nullptr));
    return true;
}

void SetCommand::sayRounding(const WantedValue& value)
{
    if (value.written == value.effective)
        return;
    const Target target = single(value.item);
    const auto words = [&](catalog::Value number) {
        return valueWords(target, session().model(), {{value.item, number}});
    };
    console().message(Texts::tr("%1: the sensor rounds %2 down to its resolution and will hold %3 %4.")
                          .arg(target.key, words(value.written), words(value.effective), unitOf(target, {})));
}

void SetCommand::next()
{
    if (!m_steps.isEmpty()) {
        const Step step = m_steps.takeFirst();
        for (const WantedValue& value : step.values)
            m_report.noteBefore(value.item, session().heldValues());
        return step.isRun ? runItem(step.values.first()) : apply(step);
    }
    if (!line().save || m_isSaving)
        return end(ExitCode::Done);
    m_isSaving = true;
    m_report.add({single(ItemId::SetValueSaving), {}, {}, SetStatus::NotTried});
    runItem({ItemId::SetValueSaving, 0, 0});
}

void SetCommand::apply(const Step& step)
{
    QList<settings::ItemValue> edits;
    for (const WantedValue& value : step.values)
        edits.append({value.item, value.effective});
    session().edit(edits);
    m_asked = session().pending().edits().keys();
    for (const settings::ItemValue& edit : std::as_const(edits)) {
        if (!m_asked.contains(edit.item))
            m_report.mark(edit.item, SetStatus::Unchanged);
    }
    if (m_asked.isEmpty())
        return next();
    m_underWay = session().apply();
    if (!m_underWay) {
        refuseWhileNotWritable();
        end(ExitCode::Refused);
    }
}

void SetCommand::runItem(const WantedValue& value)
{
    m_asked = {value.item};
    m_underWay = session().run(value.item, value.effective);
    if (!m_underWay) {
        refuseWhileNotWritable();
        end(ExitCode::Refused);
    }
}

void SetCommand::onApplyFinished(const sensor::ApplyReport& report)
{
    if (!std::exchange(m_underWay, false) || isFinished())
        return;
    m_report.markApplied(report, m_asked);
    if (report.planFailure)
        sayPlanFailure(*report.planFailure);
    sayFailures(report);
    for (const ItemId item : report.changedByItself) {
        const Target target = single(item);
        console().message(Texts::tr("%1: the sensor changed it along with the rest, to %2 (manual §%3).")
                              .arg(target.key, valueWords(target, session().model(), session().heldValues()),
                                   QString::fromLatin1(catalog::hlG2(item).section)));
    }
    report.allDone() ? next() : end(ExitCode::Refused);
}

void SetCommand::sayFailures(const sensor::ApplyReport& report)
{
    const auto say = [this](const sensor::WriteResult& result) {
        const auto& item = catalog::hlG2(result.write.first().item);
        console().message(QString::fromLatin1(item.key) + QStringLiteral(": ") +
                          ui::failureSentence(result.failure, &item));
    };
    std::ranges::for_each(report.refused, say);
    std::ranges::for_each(report.unknown, say);
    for (const sensor::WriteResult& result : report.different) {
        const Target target = single(result.write.first().item);
        console().message(
            Texts::tr("%1: the sensor accepted the value but holds %2. Read again; a PLC or the "
                      "keypad may have changed it.")
                .arg(target.key, valueWords(target, session().model(), result.readBack)));
    }
    for (const ItemId item : report.inConflict)
        console().message(
            Texts::tr("%1: somebody else changed it or the bank meanwhile; it was left alone. Set it "
                      "again if it is still wanted.")
                .arg(single(item).key));
}

void SetCommand::sayPlanFailure(const settings::PlanFailure& failure)
{
    const settings::Values goal = overlaid(session().heldValues(), session().pending().wantedValues());
    for (const settings::Refusal& refusal : failure.refusals)
        console().message(ui::refusalSentence(refusal, session().model(), goal));
    console().message(Texts::tr("Nothing was written: the sensor would refuse these values."));
}

void SetCommand::onCommandFinished(const sensor::CommandReport& report)
{
    if (!std::exchange(m_underWay, false) || isFinished())
        return;
    const auto& item = catalog::hlG2(report.item);
    if (report.status != ports::Status::Done) {
        m_report.mark(report.item,
                      report.status == ports::Status::Refused ? SetStatus::Refused : SetStatus::Unknown);
        console().message(QString::fromLatin1(item.key) + QStringLiteral(": ") +
                          ui::failureSentence(report.failure, &item));
        return end(ExitCode::Refused);
    }
    if (item.role == catalog::Role::Switch && session().held(report.item) != report.value) {
        m_report.mark(report.item, SetStatus::Different);
        console().message(
            Texts::tr("%1: the sensor accepted the value but holds another. Read again; a PLC or the "
                      "keypad may have changed it.")
                .arg(QString::fromLatin1(item.key)));
        return end(ExitCode::Refused);
    }
    m_report.mark(report.item, SetStatus::Done);
    next();
}

void SetCommand::onLost(const QString& sentence)
{
    m_lost = sentence;
    if (!m_underWay) // else the report of what is under way comes first
        end(ExitCode::Refused);
}

void SetCommand::end(ExitCode code)
{
    if (!m_lost.isEmpty())
        console().message(m_lost);
    if (line().json) {
        console().json(m_report.toJson(session().model(), session().heldValues(), session().saved()));
    } else {
        const QStringList lines = m_report.toLines(session().model(), session().heldValues());
        for (const QString& text : lines)
            console().line(text);
    }
    if (m_report.wroteASetting() && session().saved() == sensor::Saved::NotSaved)
        console().message(Texts::tr("Not saved: the sensor forgets it at power-off. Add --save to keep it."));
    const bool waits = std::ranges::any_of(m_report.results(), [](const SetResult& result) {
        return result.status == SetStatus::Done &&
               catalog::hlG2(result.target.items.first()).effect == catalog::Effect::AfterCommunicationReset;
    });
    if (waits)
        console().message(Texts::tr("Communication settings count after a restart or "
                                    "“set resettingCommunicationSettings=0”."));
    finish(code);
}

} // namespace lds::ctl

#pragma once

#include "assignment.h"
#include "session_command.h"
#include "set_report.h"

namespace lds::ctl {

/// ldsctl set: changes settings and runs switches and commands in the order given. Settings that stand
/// together are planned together. Nothing is written unless every value can be.
class SetCommand final : public SessionCommand {
    Q_OBJECT

public:
    using SessionCommand::SessionCommand;

protected:
    bool prepare() override;
    void onReady() override;
    void onLost(const QString& sentence) override;

private:
    /// Settings that are planned together, or one item to run.
    struct Step {
        QList<WantedValue> values;
        bool isRun = false;
    };

    bool proveValues();
    void sayWhoseLimits(const Assignment& assignment, catalog::SensorModel model);
    bool readAllValues();
    void addStep(const QList<WantedValue>& values);
    bool refuseUnreachable();
    bool refuseWhileNotWritable();
    void sayRounding(const WantedValue& value);

    void next();
    void apply(const Step& step);
    void runItem(const WantedValue& value);
    void onApplyFinished(const sensor::ApplyReport& report);
    void onCommandFinished(const sensor::CommandReport& report);
    void sayFailures(const sensor::ApplyReport& report);
    void sayPlanFailure(const settings::PlanFailure& failure);
    void end(ExitCode code);

    QList<Assignment> m_assignments;
    QList<Step> m_steps;
    SetReport m_report;
    QList<catalog::ItemId> m_asked; ///< Items of the apply under way.
    bool m_underWay = false;        ///< An apply or a command is; its report comes.
    bool m_isSaving = false;
    QString m_lost; ///< Why the connection is gone, once it is.
};

} // namespace lds::ctl

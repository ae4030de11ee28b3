#pragma once

#include "patient_read.h"
#include "pending_edits.h"

#include <QSet>

namespace lds::sensor {

/// Takes the sensor from what it holds to what the edits want: one write at a time, each read back and
/// compared before the next. A write is sent at most once. What the sensor refuses is left out and a new
/// order for the rest is planned from what it holds then.
class ApplyRun {
public:
    using Finished = std::function<void(const ApplyReport&)>;

    ApplyRun(RunHost& host, const PendingEdits::Edits& edits, Finished finished);

    QObject* context() { return &m_context; }
    void begin();
    void cancel();         ///< After the write under way; values set only for the way are put back first.
    void connectionGone(); ///< Ends at once.

private:
    void next();
    void replan();
    bool takePlan(const settings::Values& wanted);
    bool isFinal(const settings::Write& write) const;
    bool isUsable(const tl::expected<settings::ApplyPlan, settings::PlanFailure>& plan) const;
    settings::Values largestPart(const settings::Values& wanted, settings::Values part) const;
    bool leaveWithdrawn();
    QList<ItemId> changing(const settings::Write& write) const;

    void written(const ports::Outcome& outcome);
    void readBack();
    void compare(const settings::Values& read, const HeldValues::Changes& changes);
    void reached(const HeldValues::Changes& changes);
    void refused();
    void failStep(QList<WriteResult>& list);
    void stepEnded();
    void finish();

    settings::Values openGoals() const;
    settings::Values valuesToPutBack() const;

    RunHost& m_host;
    QObject m_context;
    PatientRead m_read;
    Finished m_finished; ///< Empty once it has run.
    ApplyReport m_report;
    settings::Values m_goals;
    settings::Values m_start; ///< What the sensor held when the run began.
    QSet<ItemId> m_onTheWay;  ///< Given, for a while, a value that nobody wants.
    QSet<ItemId> m_reached;
    QSet<ItemId> m_failed; ///< Written, and not as wanted: never written again in this run.
    QList<settings::Write> m_steps;
    WriteResult m_step;       ///< The write under way.
    QList<ItemId> m_changing; ///< What it changes.
    bool m_underWay = false;
    bool m_cancelled = false;
    bool m_mustPlan = false;
    int m_done = 0;
};

} // namespace lds::sensor

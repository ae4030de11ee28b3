#pragma once

#include "link_client.h"
#include "scheduler.h"
#include "workspace.h"

#include <array>
#include <optional>
#include <QPointer>

namespace lds::procedures {

using catalog::ItemId;

/// Why a change of the communication settings did not come to its end, or cannot begin.
enum class ChangeProblem : quint8 {
    None,
    NothingToChange,
    NotPossibleNow, ///< Not connected, for viewing only, busy, or somebody else holds the lease.
    OthersOnLine,   ///< Speed or parity: other sensors on this port are connected, and it has one speed.
    AddressInList,  ///< Another sensor of the workspace has that address on this port.
    AddressAnswers, ///< Something on the line answers to that address already.
    PortFailed,     ///< The line could not be asked whether the address is free.
    WriteFailed,    ///< Refused, or not held afterwards; see item and wire.
    SaveFailed,     ///< Refused.
    SaveUnknown,    ///< No answer to saving: nobody can tell whether it was carried out.
    ResetFailed,    ///< Refused: it still speaks as before, and as wanted once its power has been off.
    StillOld,       ///< After the reset it answers with the former settings only.
    NoAnswer,       ///< After the reset it answers neither with the new nor with the former settings.
    OtherValues,    ///< What answers with the new settings holds others.
    Cancelled,
    Disconnected, ///< The connection ended on the way there.
};

struct ChangeFailure {
    ChangeProblem problem = ChangeProblem::None;
    std::optional<ItemId> item;
    ports::Failure wire;    ///< What the sensor or the link said.
    ports::LinkReport line; ///< With PortFailed and NoAnswer.
};

/// Changes address, speed or parity of a sensor on an RS-485 line (§6.2, §4.8.5): sees that the address is
/// free, writes, saves, resets the communication, connects with the new settings and reads them back.
///
/// It holds the session's lease while it runs. Nothing is written twice: how a write without an answer ended
/// is found by reading; how a reset ended, by asking with the new settings and then with the former ones.
/// After a failure sensorAt() says with which settings the sensor answers, and goBack() restores the former
/// ones.
class CommunicationChange final : public QObject {
    Q_OBJECT

public:
    enum class State : quint8 {
        Idle,
        Checking, ///< Asking whether the new address is free.
        Writing,
        Saving,
        Resetting,
        Reopening,
        Verifying,
        Done,     ///< The sensor speaks as wanted.
        WentBack, ///< The sensor speaks as before.
        Failed,
    };
    enum class StepState : quint8 { Waiting, UnderWay, Done, Failed, NotNeeded };
    struct Timing {
        int saveMs = 15'000;   ///< Saving silences the sensor for up to seconds (§5.3.3).
        int reopenMs = 8'000;  ///< For an answer with the new settings, and again with the former ones.
        int readPauseMs = 500; ///< Between tries to read.
    };
    /// `session` on RS-485; all of them outlive this object, except the session, which may be removed.
    CommunicationChange(sensor::SensorSession& session, const sensor::Workspace& workspace,
                        ports::LinkFactory& links, ports::Scheduler& scheduler, QObject* parent = nullptr);
    ~CommunicationChange() override; ///< Gives the lease back; what is under way is left as it is.

    void setTiming(const Timing& timing) { m_timing = timing; }

    /// What forbids beginning, as far as it is known without asking the line.
    ChangeProblem obstacle(const ports::SerialSettings& serial, quint8 unit) const;
    /// False when there is an obstacle; else ended() follows, once.
    bool start(const ports::SerialSettings& serial, quint8 unit);
    bool isRunning() const;
    /// Before the reset: ends after the message under way, and what has been written is put back. While
    /// reopening: stops waiting for the sensor.
    void cancel();
    bool canCancel() const;
    /// After a failure: the former settings again. ended() follows, once.
    void goBack();
    bool canGoBack() const;
    /// After NoAnswer: asks with the new and the former settings once more. ended() follows, once.
    void searchAgain();
    bool canSearch() const;

    State state() const { return m_state; }
    bool isGoingBack() const { return m_goesBack; }
    StepState stepState(State step) const; ///< Of Checking … Verifying.
    const ChangeFailure& failure() const { return m_failure; }
    ports::ConnectionUrl formerUrl() const { return m_former; }
    ports::ConnectionUrl newUrl() const { return m_new; }
    /// The settings with which the sensor answers now; nothing when it answers with neither.
    const std::optional<ports::ConnectionUrl>& sensorAt() const { return m_sensorAt; }

Q_SIGNALS:
    void changed(); ///< State, steps, or what can be done now.
    void ended();   ///< Done, WentBack or Failed.

private:
    using Step = void (CommunicationChange::*)();

    // --- communication_change.cpp
    bool begin();
    void enter(State step);
    void skip(State step) { step_(step) = StepState::NotNeeded; }
    void fail(ChangeProblem problem, const ChangeFailure& details = {});
    void end(State state);
    StepState& step_(State step) { return m_steps[std::size_t(step)]; }
    ports::ConnectionUrl target() const { return m_goesBack ? m_former : m_new; }
    void turnBack(bool mustReset);
    static bool isSamePlace(const ports::ConnectionUrl& left, const ports::ConnectionUrl& right);
    static settings::Values valuesOf(const ports::ConnectionUrl& url);

    // --- communication_change_steps.cpp
    void check();
    void checked(const ports::LinkReport& report);
    void write();
    void writeNext();
    void compareWritten(const settings::ItemValue& written, const ports::Failure& wire);
    void save();
    void saved(const ports::Outcome& outcome);
    void reset();
    void resetEnded(const ports::Outcome& outcome);
    void reopen();
    void waitFor(const ports::ConnectionUrl& url);
    void goTo(const ports::ConnectionUrl& url);
    void notReached();
    void verify();
    void connectionChanged();
    bool stopForCancel();
    void ask(const ports::Request& request, sensor::SensorSession::Answer answer);
    /// Reads the three items; `handler` gets nothing when they could not be read.
    void read(int tries, std::function<void(const std::optional<settings::Values>&)> handler);

    QPointer<sensor::SensorSession> m_session;
    const sensor::Workspace& m_workspace;
    ports::LinkFactory& m_links;
    ports::Scheduler& m_scheduler;
    Timing m_timing;

    State m_state = State::Idle;
    std::array<StepState, std::size_t(State::Verifying) + 1> m_steps{};
    bool m_goesBack = false;
    bool m_cancelled = false;
    bool m_mustSave = true;
    bool m_mustReset = true;
    bool m_touched = false;   ///< Something was written on the way there.
    bool m_saveTried = false; ///< On the way there.
    ChangeFailure m_failure;
    ports::ConnectionUrl m_former;
    ports::ConnectionUrl m_new;
    std::optional<ports::ConnectionUrl> m_sensorAt;

    sensor::Lease m_lease;
    QPointer<sensor::LinkClient> m_probe; ///< Asks the new address.
    QList<settings::ItemValue> m_toWrite;
    bool m_askedElsewhere = false; ///< Reopening: the settings it goes to had their time.
    ports::Scheduler::TimerId m_timer = 0;
    std::unique_ptr<QObject> m_run; ///< Dies with the run, and with it every answer on its way.
};

} // namespace lds::procedures

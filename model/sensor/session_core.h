#pragma once

#include "announcer.h"
#include "apply_run.h"
#include "command_run.h"
#include "link_client.h"
#include "measurement_rate.h"
#include "reconnect_policy.h"
#include "sensor_session.h"
#include "settings_walk.h"

#include <QMap>
#include <QPointer>
#include <QSet>
#include <vector>

namespace lds::sensor {

/// The works of a SensorSession: the connection, what is held, and the runs; sensor_session.cpp is its face.
/// Everything that enters from outside (a call, an answer, a timer) does so inside a Turn.
struct SensorSession::Private final : RunHost {
    Private(SensorSession* session, ports::ConnectionUrl address, ports::LinkFactory& factory,
            ports::Scheduler& clock);
    ~Private() override;

    /// One piece of work. At the end of the outermost one, what changed is announced.
    class Turn {
    public:
        explicit Turn(Private& core)
            : m_core(core)
        {
            ++m_core.depth;
        }
        ~Turn();
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

    private:
        Private& m_core;
    };

    // --- Connection (session_connection.cpp)
    void open();
    void close();
    void tryAgain();
    void reported(const ports::LinkReport& report);
    void connectionGone(const ports::LinkReport& report);
    void startReading();
    void readEverything();
    void everythingRead(const ports::Outcome& outcome);
    void takeForNoSensor(const ports::Failure& failure);
    void becomeReady();
    void setConnection(Connection next);
    void setNotReady(bool notReady);
    void startTimer(ports::Scheduler::TimerId& timer, int delayMs, void (Private::*callback)());
    void stopTimer(ports::Scheduler::TimerId& timer);
    void measured(const measurement::MeasurementBatch& batch, const ports::PollStatistics& statistics);
    void pollRefused(const ports::Failure& failure);

    // --- Watching (session_watch.cpp)
    void walk();
    void read(const QList<ItemId>& items, ports::Urgency urgency);
    void readAgain();
    void readingEnded(const ports::Outcome& outcome);
    void voidReadings();
    QList<ItemId> readableItems(bool walkOnly) const;
    HeldValues::Changes learn(const settings::Values& values, qint64 atNs, const QList<ItemId>& own) override;
    void noteExternal(const HeldValues::Changes& changes, const QList<ItemId>& own, bool bankSwitched);
    void settlePending(const QList<ItemId>& own);
    void updateFit();

    // --- Doing (session_runs.cpp)
    bool canWrite() const;
    bool canRun(ItemId item, Value value) const;
    bool apply();
    bool run(ItemId item, Value value);
    bool askFor(const Lease& holder, const ports::Request& request, QObject* context, Answer answer);
    void askEnded(quint64 number, const ports::Outcome& outcome);
    void applyEnded(const ApplyReport& report);
    void commandEnded(const CommandReport& report);
    void runEnded();
    void endRuns();
    template <typename Change>
    void changePending(Change change);

    // --- RunHost
    catalog::SensorModel sensorModel() const override;
    const settings::Values& heldNow() const override { return held.values(); }
    bool linkReaches(ItemId item) const override { return reachable.contains(item); }
    std::optional<PendingEdit> pendingEdit(ItemId item) const override { return pending.find(item); }
    void ask(const ports::Request& request, QObject* context, Handler handler) override;
    void later(int delayMs, QObject* context, std::function<void()> callback) override;
    void setSaved(Saved next) override;
    Saved savedNow() const override { return saved; }
    void editReached(ItemId item, Value value) override;
    void runProgressed(int done, int total) override;

    SensorSession* q;
    ports::ConnectionUrl url;
    ports::LinkFactory& links;
    ports::Scheduler& scheduler;
    Timing timing;
    QString name;
    catalog::ModelMask fit = catalog::everyModel;

    LinkClient* client = nullptr; ///< A child of the session; nullptr while closed.
    QSet<ItemId> reachable;       ///< As of the latest open().
    ReconnectPolicy reconnecting{1, 1};
    Connection connection = Connection::Closed;
    ports::LinkReport report;
    bool notReady = false;
    ports::Scheduler::TimerId retryTimer = 0;
    ports::Scheduler::TimerId rereadTimer = 0;
    ports::Scheduler::TimerId walkTimer = 0;

    HeldValues held;
    SettingsWalk settingsWalk;
    quint64 readingTicket = 0; ///< A reading that carries another one has been made void.
    bool readingUnderWay = false;
    bool readingIsFull = false;
    bool readAllWanted = false;
    bool bankIsOther = false; ///< Somebody switched the bank and its values are not read yet.

    PendingEdits pending;
    LeaseDesk desk;
    Lease lease;
    std::unique_ptr<ApplyRun> applying;
    std::unique_ptr<CommandRun> running;
    struct Asked { ///< By a procedure.
        ports::Request request;
        QPointer<QObject> context;
        Answer answer;
    };
    QMap<quint64, Asked> asked; ///< Without an answer yet, in the order they were asked.
    quint64 lastAsked = 0;
    QList<ItemId> writtenByProcedure; ///< And not read since.
    Saved saved = Saved::Unknown;

    std::optional<measurement::Measurement> latest;
    measurement::TrendStore trend;
    ports::PollStatistics statistics;
    MeasurementRate rate;

    Announcer announcer;
    int depth = 0;
    quint32 toldBusy = 0; ///< canWrite(), isApplying(), isRunning() as last announced.
    std::vector<std::unique_ptr<ApplyRun>> retiredApplies; ///< Until nothing of them is on the stack.
    std::vector<std::unique_ptr<CommandRun>> retiredCommands;
};

} // namespace lds::sensor

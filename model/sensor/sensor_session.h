#pragma once

#include "model_guess.h"
#include "pending_edits.h"
#include "scheduler.h"
#include "session_types.h"
#include "trend_store.h"
#include "value_text.h"

#include <functional>
#include <memory>
#include <optional>
#include <QObject>

namespace lds::sensor {

/// Everything known about one sensor and everything wanted from it. Lives in the GUI thread (or in
/// ldsctl's main thread); talks to its link by values only; never blocks.
///
/// After opening it reads every readable item, then polls measurements and walks slowly through the
/// settings beside that, so that it knows each value's age and notices what a PLC or the keypad changed.
/// After a cut it reconnects by itself, reads everything again and compares; pending edits stay and are
/// never written by reconnecting.
class SensorSession final : public QObject {
    Q_OBJECT

public:
    struct Timing {
        int pollIntervalMs = 10;       ///< Measurement polls.
        int walkIntervalMs = 500;      ///< One small piece of the settings at each step.
        int reconnectFirstMs = 500;    ///< Doubles with every try …
        int reconnectLongestMs = 8000; ///< … up to this.
        int saveTimeoutMs = 15000;     ///< Saving silences the sensor for up to seconds (§5.3.3).
    };

    SensorSession(ports::ConnectionUrl url, ports::LinkFactory& links, ports::Scheduler& scheduler,
                  QObject* parent = nullptr);
    ~SensorSession() override;

    // --- Who it is
    const ports::ConnectionUrl& url() const;
    QString name() const; ///< What a person calls it; until named the address, over RS-485 port and unit.
    void setName(const QString& name);
    catalog::SensorModel model() const; ///< Stated in the URL, else the smallest type that fits.
    bool modelIsStated() const;
    catalog::ModelMask modelsThatFit() const; ///< By what was read; every model before that.
    /// The stated type does not fit what the sensor holds.
    bool modelContradicted() const;
    void setModel(catalog::SensorModel model); ///< The person's correction.

    // --- Connection
    void setTiming(const Timing& timing); ///< Before open().
    void open();
    void close();    ///< Pending edits stay.
    void retryNow(); ///< While Reconnecting: at once instead of at the next try.
    /// The same sensor is reached elsewhere from now on: takes the URL and, unless Closed, connects there.
    /// Pending edits, name, trend and what was held stay.
    void moveTo(const ports::ConnectionUrl& url);
    Connection connection() const;
    /// The latest; says why a connection failed. While the next try is under way its state is Opening and
    /// the failure is still that of the last one.
    const ports::LinkReport& linkReport() const;
    bool isReady() const { return connection() == Connection::Ready; }
    /// The sensor answers "not ready": it is in its menu, or saving (§5.2.2).
    bool isSensorNotReady() const;

    // --- What the sensor holds
    const catalog::Catalog& catalog() const;
    std::optional<Value> held(ItemId item) const; ///< Nothing until read; write-only items never.
    const settings::Values& heldValues() const;
    qint64 readAtNs(ItemId item) const; ///< Monotonic time of the last reading; −1 when never.
    bool reaches(ItemId item) const;    ///< False also before the first open.
    /// True when what is shown for the item may not be what the sensor holds (not connected).
    bool isStale() const { return connection() != Connection::Ready; }
    void readAll();

    // --- What a person wants
    const PendingEdits& pending() const;
    /// A stored value that can be written: only such items can be edited; the rest goes by run().
    bool isEditable(ItemId item) const;
    /// The text a person typed. On success the edit is pending and the result says what the sensor will
    /// make of it (digits below the resolution are rounded down). On failure nothing changes.
    tl::expected<settings::ParsedValue, settings::ParseFailure> editText(ItemId item, const QString& text);
    void edit(const QList<settings::ItemValue>& wanted); ///< One undoable step; values within the limits.
    void revert(const QList<ItemId>& items);
    void revertAll();
    void undo();
    void redo();
    void keepMine(ItemId item); ///< Resolves a conflict in favour of the edit.
    /// Rules the sensor would break if all pending edits were applied; empty when it could be.
    QList<settings::Refusal> problems() const;
    tl::expected<settings::ApplyPlan, settings::PlanFailure> plan() const;

    // --- Doing it
    bool canWrite() const; ///< Ready, not view-only, nobody else holds the lease, sensor ready.
    bool isViewOnly() const;
    /// False when canWrite() is; else applyFinished follows, always once and never inside this call. Edits in
    /// conflict are left alone until keepMine().
    bool apply();
    void cancelApply(); ///< After the write that is under way.
    bool isApplying() const;
    /// Runs a command, switch or procedure item (save, bank, laser, reset, zero). False when not possible
    /// now or the item has no such value; else commandFinished follows, always once and never inside this
    /// call. What it changes is read back first (see command_effects.h).
    bool run(ItemId item, Value value);
    bool isRunning() const; ///< A command is under way.
    Saved saved() const;
    LeaseDesk& leases();
    using Answer = std::function<void(const ports::Outcome&)>;
    /// One message of the procedure that holds `lease`; a write goes out once, whatever becomes of it. False
    /// when the lease is not of this session, there is no Ready connection, or it is for viewing only and
    /// this is a write; else `answer` runs exactly once, never inside this call, as Unknown and
    /// ConnectionLost when the connection ends first; not at all once `context` has died. What is read is
    /// held from then on; what the procedure has written is nobody else's change.
    bool ask(const Lease& lease, const ports::Request& request, QObject* context, Answer answer);

    // --- Live
    const std::optional<measurement::Measurement>&
    latest() const; ///< Nothing before the first, or while stale.
    const measurement::TrendStore& trend() const;
    void clearTrend();
    const ports::PollStatistics& pollStatistics() const;
    /// Measurements per second over the last second or so.
    double measurementRate() const;

Q_SIGNALS:
    void connectionChanged();
    void identityChanged();  ///< Name, model or fit.
    void readinessChanged(); ///< isSensorNotReady()
    void heldChanged(const QList<lds::catalog::ItemId>& items);
    void pendingChanged(); ///< Edits, undo, redo or conflicts.
    void savedChanged();
    void busyChanged(); ///< canWrite(), isApplying() or isRunning() may differ.
    void externallyChanged(const QList<lds::sensor::ExternalChange>& changes);
    void conflictsFound(const QList<lds::catalog::ItemId>& items);
    void applyProgress(int done, int total);
    void applyFinished(const lds::sensor::ApplyReport& report);
    void commandFinished(const lds::sensor::CommandReport& report);
    void measured(); ///< latest() and trend() have grown; at most one per batch.

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace lds::sensor

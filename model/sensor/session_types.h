#pragma once

#include "apply_plan.h"
#include "sensor_link.h"

#include <functional>
#include <memory>
#include <optional>
#include <QList>
#include <QMap>
#include <QString>

namespace lds::sensor {

using catalog::ItemId;
using catalog::Value;

/// Where a session stands with its sensor.
enum class Connection : quint8 {
    Closed,
    Opening,
    Reading, ///< Open; the settings are being read for the first time (or again after a cut).
    Ready,
    Reconnecting, ///< Cut or not reached; tries again by itself. Values on screen are the last known ones.
};

/// Whether the sensor's memory holds what its RAM holds (§5.1). Saving is never automatic.
enum class Saved : quint8 {
    Unknown, ///< After connecting nobody can tell; also after someone else changed a value.
    Saved,
    NotSaved, ///< Something was written since the last save: gone when the power goes.
};

/// A change a person wants and the sensor does not have yet.
struct PendingEdit {
    Value wanted = 0;          ///< As it will be after rounding down to the resolution.
    Value base = 0;            ///< What the sensor held when the edit was made or last confirmed.
    bool conflict = false;     ///< The sensor's value has moved away from base, or another bank is running:
                               ///< such an edit is not written before keepMine().
    std::optional<Value> bank; ///< The bank that ran when it was made, for an item each bank has its own of.
    bool baseKnown = true;     ///< False while the sensor has not been read yet; base then means nothing.
    friend bool operator==(const PendingEdit&, const PendingEdit&) = default;
};

/// How one write of an apply went.
struct WriteResult {
    settings::Write write;
    settings::Values before; ///< What was held for the written items when the apply began.
    ports::Status status = ports::Status::Unknown;
    ports::Failure failure;
    settings::Values readBack; ///< What the sensor held afterwards; empty when it could not be read.
};

/// One summary for a whole apply.
struct ApplyReport {
    QList<WriteResult> written;   ///< Done and read back as wanted: these edits are gone.
    QList<WriteResult> refused;   ///< The sensor said no; the edits stay.
    QList<WriteResult> different; ///< Accepted, but reads back as another value; the edits stay.
    /// Whether it was carried out is not known, or it was not answered and the sensor holds another value
    /// (readBack says which). Never repeated; the edits stay.
    QList<WriteResult> unknown;
    QList<ItemId> notTried; ///< Edits left alone: cancelled, connection lost, or no order of writes.
    QList<ItemId>
        inConflict; ///< Edits left alone because the sensor's value has moved: keepMine() or revert().
    QList<ItemId> changedByItself; ///< Items the sensor changed along the way (trigger mode, §4.3.4).
    bool cancelled = false;
    bool connectionLost = false;
    std::optional<settings::PlanFailure> planFailure; ///< Nothing was written: the goal breaks a rule.
    bool allDone() const
    {
        return refused.isEmpty() && different.isEmpty() && unknown.isEmpty() && notTried.isEmpty() &&
               inConflict.isEmpty() && !cancelled && !connectionLost && !planFailure;
    }
};

/// How a command or switch (save, reset, bank, laser, ...) went.
struct CommandReport {
    ItemId item = ItemId::SetValueSaving;
    Value value = 0;
    ports::Status status = ports::Status::Unknown;
    ports::Failure failure;
};

/// Someone other than this session changed the sensor.
struct ExternalChange {
    ItemId item;
    Value before;
    Value after;
};

/// Held by whoever may write: an apply, a procedure. Released when destroyed.
class LeaseDesk;
class Lease {
public:
    Lease() = default;
    Lease(Lease&& other) noexcept;
    Lease& operator=(Lease&& other) noexcept;
    ~Lease();
    bool isHeld() const { return m_desk != nullptr; }
    void release();

private:
    friend class LeaseDesk;
    struct State {
        bool taken = false;
        std::function<void()> changed;
    };
    explicit Lease(std::shared_ptr<State> desk)
        : m_desk(std::move(desk))
    {}
    std::shared_ptr<State> m_desk;
};

/// Hands out one lease at a time.
class LeaseDesk {
public:
    /// `changed` runs whenever the lease is taken or given back.
    explicit LeaseDesk(std::function<void()> changed = {});
    ~LeaseDesk();
    LeaseDesk(const LeaseDesk&) = delete;
    LeaseDesk& operator=(const LeaseDesk&) = delete;

    /// An unheld Lease when somebody else has it.
    Lease acquire();
    bool isTaken() const { return m_state->taken; }
    bool hasLent(const Lease& lease) const { return lease.m_desk == m_state; }

private:
    std::shared_ptr<Lease::State> m_state;
};

} // namespace lds::sensor

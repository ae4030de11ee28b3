#pragma once

#include "held_values.h"
#include "session_types.h"

#include <functional>

namespace lds::sensor {

/// What a run (an apply, a command) asks of the session it works for.
class RunHost {
public:
    using Handler = std::function<void(const ports::Outcome&)>;

    virtual ~RunHost() = default;

    virtual catalog::SensorModel sensorModel() const = 0;
    virtual const settings::Values& heldNow() const = 0;
    virtual bool linkReaches(ItemId item) const = 0;
    virtual std::optional<PendingEdit> pendingEdit(ItemId item) const = 0;

    virtual void ask(const ports::Request& request, QObject* context, Handler handler) = 0;
    virtual void later(int delayMs, QObject* context, std::function<void()> callback) = 0;

    /// The sensor was read. What changed in `own` items this program did; the rest somebody else.
    virtual HeldValues::Changes learn(const settings::Values& read, qint64 atNs,
                                      const QList<ItemId>& own) = 0;
    virtual void setSaved(Saved saved) = 0;
    virtual Saved savedNow() const = 0;
    /// The sensor holds what the edit asked for.
    virtual void editReached(ItemId item, Value value) = 0;
    virtual void runProgressed(int done, int total) = 0;
};

/// Whether the outcome says that there is no connection any more.
bool isConnectionGone(const ports::Outcome& outcome);

} // namespace lds::sensor

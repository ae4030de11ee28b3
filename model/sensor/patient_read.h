#pragma once

#include "run_host.h"

#include <QObject>

namespace lds::sensor {

/// Reads items, and again after a pause when the sensor does not answer or is not ready: reading may be
/// repeated, writing never. Gives up after a bounded number of tries.
class PatientRead {
public:
    struct Patience {
        int tries = 3;
        int pauseMs = 200;
    };
    enum class End { Read, NotReady, Failed, ConnectionGone };
    /// `changes` is what the session learned from it; empty unless Read.
    using Handler =
        std::function<void(End end, const settings::Values& read, const HeldValues::Changes& changes)>;

    explicit PatientRead(RunHost& host)
        : m_host(host)
    {}

    /// One at a time. What changed in `own` items this program did.
    void start(const QList<ItemId>& items, const QList<ItemId>& own, Patience patience, Handler handler);

private:
    void attempt();
    void answered(const ports::Outcome& outcome);

    RunHost& m_host;
    QObject m_context; ///< Dies with this object, and with it every answer on its way here.
    QList<ItemId> m_items;
    QList<ItemId> m_own;
    Patience m_patience;
    Handler m_handler;
};

} // namespace lds::sensor

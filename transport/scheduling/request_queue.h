#pragma once

#include "sensor_link.h"

#include <array>
#include <optional>
#include <QQueue>
#include <variant>

namespace lds::scheduling {

/// Decides what goes out next on a connection that carries one request at a time: a person's requests
/// before a procedure's, both before the slow walk, all before polls, and first come first served among
/// equals. Pure logic: it sends nothing and knows no time.
class RequestQueue {
public:
    struct Poll {};
    using Work = std::variant<Poll, ports::Request>;

    void add(const ports::Request& request);
    /// A poll falls due. False when something is under way or waiting: then the tick is dropped and
    /// counted, never queued, so that late polls do not pile up in front of anybody.
    bool addPoll();
    /// A tick that passed without anybody looking counts as dropped, too.
    void countDropped(quint64 ticks) { m_droppedPolls += ticks; }

    /// What goes out now; the connection is then busy until finished(). Nothing while it is busy.
    std::optional<Work> take();
    void finished() { m_busy = false; }
    bool isBusy() const { return m_busy; }

    /// Forgets everything, what is under way included; returns the waiting requests in their order.
    QList<ports::Request> clear();

    quint64 droppedPolls() const { return m_droppedPolls; }
    void resetDroppedPolls() { m_droppedPolls = 0; }

private:
    bool isWaiting() const;

    static constexpr std::size_t urgencies = 3;
    std::array<QQueue<ports::Request>, urgencies> m_waiting; ///< Indexed by ports::Urgency.
    bool m_pollDue = false;
    bool m_busy = false;
    quint64 m_droppedPolls = 0;
};

} // namespace lds::scheduling

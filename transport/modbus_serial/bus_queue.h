#pragma once

#include "connection.h"
#include "unit_record.h"

#include <array>
#include <optional>
#include <QList>

namespace lds::modbus {

using Ticket = quint64; ///< 0 is never one.

/// Decides which exchange goes next on a bus that many share: a person's before a procedure's, before the
/// slow walk, before polls, whoever's they are; first come first served among equals, so that polls go
/// round. A unit that was silent is left out while its pause lasts, unless a person or a procedure asks.
///
/// The slow walk is kept slow: after one of its exchanges the polls that were waiting go first, or sixteen
/// walks would leave no room for measurements on a slow line. Pure logic.
class BusQueue {
public:
    void add(Ticket ticket, quint8 unit, Turn turn);
    bool remove(Ticket ticket); ///< Whether it was waiting.
    void hurry(Ticket ticket, Turn turn);
    bool isEmpty() const;

    /// Removes and returns what goes now; nothing when nothing may.
    std::optional<Ticket> take(const UnitRecord& units, qint64 nowNs);
    /// When what waits only for a pause may go; nothing when nothing waits for one.
    std::optional<qint64> nextDueNs(const UnitRecord& units) const;

private:
    struct Entry {
        Ticket ticket = 0;
        quint8 unit = 0;
    };
    using Waiting = QList<Entry>;
    Waiting& waiting(Turn turn) { return m_waiting.at(std::size_t(turn)); }
    static bool heedsPauses(Turn turn) { return turn >= Turn::Background; }
    std::optional<Ticket> takeFrom(Turn turn, const UnitRecord& units, qint64 nowNs);

    std::array<Waiting, 4> m_waiting;   ///< Indexed by Turn.
    QList<Ticket> m_pollsBeforeTheWalk; ///< Those that go before its next exchange.
};

} // namespace lds::modbus

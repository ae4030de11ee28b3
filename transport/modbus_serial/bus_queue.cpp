#include "bus_queue.h"

#include <algorithm>

namespace lds::modbus {

void BusQueue::add(Ticket ticket, quint8 unit, Turn turn) { waiting(turn).append({ticket, unit}); }

bool BusQueue::remove(Ticket ticket)
{
    m_pollsBeforeTheWalk.removeOne(ticket);
    return std::ranges::any_of(m_waiting, [ticket](Waiting& entries) {
        return entries.removeIf([ticket](const Entry& entry) { return entry.ticket == ticket; }) > 0;
    });
}

void BusQueue::hurry(Ticket ticket, Turn turn)
{
    for (std::size_t later = std::size_t(turn) + 1; later < m_waiting.size(); ++later) {
        Waiting& entries = m_waiting.at(later);
        const auto found = std::ranges::find(entries, ticket, &Entry::ticket);
        if (found == entries.end())
            continue;
        waiting(turn).append(*found);
        entries.erase(found);
        m_pollsBeforeTheWalk.removeOne(ticket);
        return;
    }
}

bool BusQueue::isEmpty() const
{
    return std::ranges::all_of(m_waiting, [](const Waiting& entries) { return entries.isEmpty(); });
}

std::optional<Ticket> BusQueue::take(const UnitRecord& units, qint64 nowNs)
{
    for (const Turn turn : {Turn::Person, Turn::Procedure}) {
        if (const auto ticket = takeFrom(turn, units, nowNs))
            return ticket;
    }
    if (m_pollsBeforeTheWalk.isEmpty()) {
        if (const auto ticket = takeFrom(Turn::Background, units, nowNs)) {
            for (const Entry& poll : std::as_const(waiting(Turn::Poll))) {
                if (units.pausedUntilNs(poll.unit) <= nowNs)
                    m_pollsBeforeTheWalk.append(poll.ticket);
            }
            return ticket;
        }
    }
    const auto poll = takeFrom(Turn::Poll, units, nowNs);
    if (poll) {
        m_pollsBeforeTheWalk.removeOne(*poll);
        return poll;
    }
    m_pollsBeforeTheWalk.clear(); // Those left have been paused since.
    return takeFrom(Turn::Background, units, nowNs);
}

std::optional<Ticket> BusQueue::takeFrom(Turn turn, const UnitRecord& units, qint64 nowNs)
{
    Waiting& entries = waiting(turn);
    const auto mayGo = [&](const Entry& entry) {
        return !heedsPauses(turn) || units.pausedUntilNs(entry.unit) <= nowNs;
    };
    const auto found = std::ranges::find_if(entries, mayGo);
    if (found == entries.end())
        return std::nullopt;
    const Ticket ticket = found->ticket;
    entries.erase(found);
    return ticket;
}

std::optional<qint64> BusQueue::nextDueNs(const UnitRecord& units) const
{
    std::optional<qint64> due;
    for (const Waiting& entries : m_waiting) {
        for (const Entry& entry : entries) {
            const qint64 entryNs = units.pausedUntilNs(entry.unit);
            due = due ? qMin(*due, entryNs) : entryNs;
        }
    }
    return due;
}

} // namespace lds::modbus

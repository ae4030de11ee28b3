#include "request_queue.h"

#include <algorithm>

namespace lds::scheduling {

void RequestQueue::add(const ports::Request& request)
{
    m_waiting.at(std::size_t(request.urgency)).enqueue(request);
}

bool RequestQueue::addPoll()
{
    if (m_busy || m_pollDue || isWaiting()) {
        ++m_droppedPolls;
        return false;
    }
    m_pollDue = true;
    return true;
}

std::optional<RequestQueue::Work> RequestQueue::take()
{
    if (m_busy)
        return std::nullopt;
    for (auto& waiting : m_waiting) {
        if (waiting.isEmpty())
            continue;
        m_busy = true;
        return waiting.dequeue();
    }
    if (!m_pollDue)
        return std::nullopt;
    m_pollDue = false;
    m_busy = true;
    return Poll{};
}

QList<ports::Request> RequestQueue::clear()
{
    QList<ports::Request> requests;
    for (auto& waiting : m_waiting) {
        requests += waiting;
        waiting.clear();
    }
    m_busy = false;
    m_pollDue = false;
    return requests;
}

bool RequestQueue::isWaiting() const
{
    return std::any_of(m_waiting.begin(), m_waiting.end(),
                       [](const auto& waiting) { return !waiting.isEmpty(); });
}

} // namespace lds::scheduling

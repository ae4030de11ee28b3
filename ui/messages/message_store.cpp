#include "message_store.h"

#include "message_filter.h"
#include "message_log.h"

#include <algorithm>

namespace lds::ui {

MessageStore::Key MessageStore::append(const ports::Frame& frame)
{
    const Key key{m_next++, isPoll(frame)};
    Ring& ring = key.poll ? m_polls : m_others;
    ring.entries.push_back({key.sequence, frame});
    ring.bytes += footprint(frame);
    return key;
}

void MessageStore::trim()
{
    trim(m_others, m_bounds.messages, m_bounds.bytes);
    trim(m_polls, m_bounds.polls, m_bounds.pollBytes);
}

void MessageStore::trim(Ring& ring, int most, qsizetype mostBytes)
{
    if (qsizetype(ring.entries.size()) <= most && ring.bytes <= mostBytes)
        return;
    const qsizetype down = most - most / 20; // a twentieth at a time
    const qsizetype downBytes = mostBytes - mostBytes / 20;
    while (!ring.entries.empty() && (qsizetype(ring.entries.size()) > down || ring.bytes > downBytes)) {
        ring.bytes -= footprint(ring.entries.front().frame);
        ring.entries.pop_front();
        ++m_trimmed;
    }
}

void MessageStore::clear()
{
    m_others = {};
    m_polls = {};
    m_trimmed = 0;
}

bool MessageStore::contains(const Key& key) const
{
    const Ring& where = ring(key);
    const auto found = find(where, key.sequence);
    return found != where.entries.end() && found->sequence == key.sequence;
}

const ports::Frame& MessageStore::frame(const Key& key) const { return find(ring(key), key.sequence)->frame; }

QList<MessageStore::Key> MessageStore::keys() const
{
    QList<Key> result;
    result.reserve(size());
    auto other = m_others.entries.begin();
    auto poll = m_polls.entries.begin();
    while (other != m_others.entries.end() || poll != m_polls.entries.end()) {
        const bool takePoll = other == m_others.entries.end() ||
                              (poll != m_polls.entries.end() && poll->sequence < other->sequence);
        result.append(takePoll ? Key{(poll++)->sequence, true} : Key{(other++)->sequence, false});
    }
    return result;
}

QList<ports::Frame> MessageStore::takeAll()
{
    QList<ports::Frame> frames;
    frames.reserve(size());
    for (const Key& key : keys())
        frames.append(frame(key));
    clear();
    return frames;
}

std::deque<MessageStore::Entry>::const_iterator MessageStore::find(const Ring& ring, quint64 sequence)
{
    return std::lower_bound(ring.entries.begin(), ring.entries.end(), sequence,
                            [](const Entry& entry, quint64 wanted) { return entry.sequence < wanted; });
}

} // namespace lds::ui

#pragma once

#include "frame.h"

#include <deque>
#include <QList>

namespace lds::ui {

/// The messages kept, newest last, bounded in number and in bytes. Polls have a bound of their own: a
/// hundred of them a second must not push out the one write a person looks for.
class MessageStore {
public:
    struct Bounds {
        int messages = 20'000; ///< Other than polls.
        int polls = 10'000;
        qsizetype bytes = 24 * 1024 * 1024;
        qsizetype pollBytes = 12 * 1024 * 1024;
    };
    /// Which message: ascending in order of arrival. Polls and others live in two rings.
    struct Key {
        quint64 sequence = 0;
        bool poll = false;
        friend bool operator==(const Key&, const Key&) = default;
    };

    MessageStore() = default;
    explicit MessageStore(const Bounds& bounds)
        : m_bounds(bounds)
    {}

    Key append(const ports::Frame& frame);
    void trim(); ///< Removes the oldest beyond the bounds, some more at a time so that it is rare.
    void clear();

    bool contains(const Key& key) const;
    const ports::Frame& frame(const Key& key) const; ///< contains(key) holds.
    QList<Key> keys() const;                         ///< In order of arrival.
    QList<ports::Frame> takeAll();                   ///< In order of arrival; leaves it empty.

    qsizetype size() const { return qsizetype(m_others.entries.size() + m_polls.entries.size()); }
    qsizetype bytes() const { return m_others.bytes + m_polls.bytes; }
    quint64 trimmed() const { return m_trimmed; } ///< Since the last clear().

private:
    struct Entry {
        quint64 sequence;
        ports::Frame frame;
    };
    struct Ring {
        std::deque<Entry> entries;
        qsizetype bytes = 0;
    };
    void trim(Ring& ring, int most, qsizetype mostBytes);
    const Ring& ring(const Key& key) const { return key.poll ? m_polls : m_others; }
    static std::deque<Entry>::const_iterator find(const Ring& ring, quint64 sequence);

    Bounds m_bounds;
    Ring m_others;
    Ring m_polls;
    quint64 m_next = 1;
    quint64 m_trimmed = 0;
};

} // namespace lds::ui

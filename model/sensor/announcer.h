#pragma once

#include "session_types.h"

#include <deque>
#include <functional>
#include <optional>

namespace lds::sensor {

class SensorSession;

/// Collects what a session has to tell while it works, and tells it when the work at hand is done: slots
/// always find a session that is of one piece, and may do with it what they like, deleting it included.
class Announcer {
public:
    /// In the order they are told.
    enum class News : quint32 { Connection, Identity, Readiness, Saved, Pending, Busy, Measured, Count };
    using Tell = std::function<void()>;

    explicit Announcer(SensorSession* session)
        : m_session(session)
    {}

    void add(News news) { m_news |= bit(news); }
    void addHeld(const QList<ItemId>& items);
    void add(Tell tell) { m_tell.push_back(std::move(tell)); }

    void tell();     ///< Returns at once when telling is under way further up the stack.
    void tellLast(); ///< For the session's end: only what somebody was promised.

private:
    static constexpr quint32 bit(News news) { return 1U << quint32(news); }
    Tell takeNext();
    Tell tellOf(News news) const;

    SensorSession* m_session;
    quint32 m_news = 0;
    QList<ItemId> m_held;
    std::deque<Tell> m_tell;
    bool m_telling = false;
};

} // namespace lds::sensor

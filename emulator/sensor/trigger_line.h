#pragma once

#include <QtGlobal>

namespace lds::emulator {

/// The trigger input line (§4.6.2): a level has to last 2 ms to be taken; what is shorter is not seen.
/// Times are nanoseconds of one monotonic clock.
class TriggerLine {
public:
    static constexpr qint64 shortestNs = 2'000'000;

    void set(bool on, qint64 nowNs)
    {
        follow(nowNs);
        if (on == m_wire)
            return;
        m_wire = on;
        m_sinceNs = nowNs;
    }
    /// The level taken at this moment. Not before the moment of the last call.
    bool at(qint64 nowNs)
    {
        follow(nowNs);
        return m_taken;
    }
    bool taken() const { return m_taken; }

private:
    void follow(qint64 nowNs)
    {
        if (m_wire != m_taken && nowNs - m_sinceNs >= shortestNs)
            m_taken = m_wire;
    }

    bool m_wire = false;
    bool m_taken = false;
    qint64 m_sinceNs = 0;
};

} // namespace lds::emulator

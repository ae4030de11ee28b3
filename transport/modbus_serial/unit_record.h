#pragma once

#include <array>
#include <QtGlobal>

namespace lds::modbus {

/// What a bus remembers of its units while its port is open: who may still owe an answer, and whom to leave
/// alone for a while. Pure logic; the time is the caller's.
class UnitRecord {
public:
    static constexpr qint64 firstPauseNs = 100'000'000;
    static constexpr qint64 longestPauseNs = 2'000'000'000;

    /// An older answer may be under way: at first of every unit, since somebody may have asked before the
    /// port was opened.
    bool isDoubtful(quint8 unit) const { return m_units.at(unit).doubtful; }
    void doubt(quint8 unit) { m_units.at(unit).doubtful = true; }
    void trust(quint8 unit) { m_units.at(unit).doubtful = false; }

    /// Not to be asked before this time, but for a person or a procedure; 0 when at any time.
    qint64 pausedUntilNs(quint8 unit) const { return m_units.at(unit).pausedUntilNs; }
    void silent(quint8 unit, qint64 nowNs); ///< Each time in a row makes the pause longer.
    void answered(quint8 unit);

private:
    struct Unit {
        bool doubtful = true;
        qint64 pauseNs = 0;
        qint64 pausedUntilNs = 0;
    };
    std::array<Unit, 256> m_units;
};

} // namespace lds::modbus

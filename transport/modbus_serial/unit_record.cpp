#include "unit_record.h"

namespace lds::modbus {

void UnitRecord::silent(quint8 unit, qint64 nowNs)
{
    Unit& record = m_units.at(unit);
    record.pauseNs = record.pauseNs == 0 ? firstPauseNs : qMin(2 * record.pauseNs, longestPauseNs);
    record.pausedUntilNs = nowNs + record.pauseNs;
}

void UnitRecord::answered(quint8 unit)
{
    m_units.at(unit).pauseNs = 0;
    m_units.at(unit).pausedUntilNs = 0;
}

} // namespace lds::modbus

#include "server_faults.h"

#include "modbus_pdu.h"

namespace lds::emulator {

void ServerFaults::add(Fault fault, FaultOn on, int times)
{
    for (int i = 0; i < times; ++i)
        m_waiting.append({fault, on});
}

std::optional<Fault> ServerFaults::take(quint8 functionCode)
{
    for (qsizetype i = 0; i < m_waiting.size(); ++i) {
        const FaultOn on = m_waiting.at(i).on;
        if (on == FaultOn::AnyRequest || (on == FaultOn::Writes) == modbus::isWrite(functionCode))
            return m_waiting.takeAt(i).fault;
    }
    return std::nullopt;
}

} // namespace lds::emulator

#include "fake_serial_line.h"

#include "modbus_rtu_framing.h"

namespace lds::tests {

void FakeSerialLine::ask(quint8 unit, const QByteArray& pdu, int timeoutMs)
{
    if (m_busy)
        qFatal("two requests on the wire");
    m_busy = true;
    asked.append({unit, quint8(pdu.at(0)), timeoutMs, m_clock->nowNs()});
    const bool answers = !silentUnits.contains(unit);
    m_clock->after(answers ? exchangeMs : timeoutMs, this, [this, unit, pdu, answers] {
        m_busy = false;
        Q_EMIT sent();
        if (answers) {
            QByteArray answer = pdu.first(1);
            if (pdu.at(0) == 0x01)
                answer += QByteArray::fromHex("0100");
            else if (pdu.at(0) == 0x03)
                answer += char(2 * quint8(pdu.at(4))) + QByteArray(2 * quint8(pdu.at(4)), '\0');
            else
                answer = pdu.first(5);
            Q_EMIT heard(modbus::encodeRtuFrame(unit, answer));
        }
        Q_EMIT ended(answers);
    });
}

QList<int> FakeSerialLine::dataUnits() const
{
    QList<int> units;
    for (const Asked& request : asked) {
        if (request.function != 0x01)
            units.append(request.unit);
    }
    return units;
}

} // namespace lds::tests

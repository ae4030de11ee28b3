#include "modbus_message_buffer.h"

#include "modbus_tcp_framing.h"

namespace lds::emulator {

namespace {
constexpr int lengthEnd = 6; ///< Bytes up to and with the length field; it counts from here on.
}

ModbusMessageBuffer::State ModbusMessageBuffer::feed(const QByteArray& bytes, QList<QByteArray>& messages)
{
    m_bytes.append(bytes);
    QList<QByteArray> whole;
    qsizetype start = 0;
    while (m_bytes.size() - start >= lengthEnd) {
        // decodeHeader wants the unit identifier too, which may not have arrived.
        const auto header = modbus::decodeHeader(m_bytes.mid(start, lengthEnd) + '\0');
        const int size = lengthEnd + header.length;
        if (size > modbus::longestMessage)
            return State::Overlong;
        if (m_bytes.size() - start < size)
            break;
        if (header.protocol == 0 && size >= modbus::shortestMessage)
            whole.append(m_bytes.mid(start, size));
        start += size;
    }
    if (start != m_bytes.size())
        return m_bytes.size() > modbus::longestMessage ? State::Overlong : State::Waiting;
    m_bytes.clear();
    messages.append(whole);
    return State::Empty;
}

} // namespace lds::emulator

#pragma once

#include <QByteArray>

namespace lds::slmp {

/// Appends little-endian numbers to a message.
class Writer {
public:
    Writer& u8(quint8 value) { return number(value, 1); }
    Writer& u16(quint16 value) { return number(value, 2); }
    Writer& u24(quint32 value) { return number(value, 3); }
    Writer& u32(quint32 value) { return number(value, 4); }
    Writer& bytes(const QByteArray& bytes)
    {
        m_bytes.append(bytes);
        return *this;
    }
    const QByteArray& result() const { return m_bytes; }

private:
    Writer& number(quint32 value, int size)
    {
        for (int i = 0; i < size; ++i)
            m_bytes.append(char((value >> (8 * i)) & 0xff));
        return *this;
    }

    QByteArray m_bytes;
};

} // namespace lds::slmp

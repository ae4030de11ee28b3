#pragma once

#include <QByteArray>
#include <QByteArrayView>

namespace lds::slmp {

/// Takes little-endian numbers off a message. It never reads past the end: what is missing reads as 0 and
/// makes the reader fail for good, so a decoder may ask once, at the end. The bytes must outlive it.
class Reader {
public:
    explicit Reader(QByteArrayView bytes)
        : m_bytes(bytes)
    {}

    bool failed() const { return m_failed; }
    qsizetype left() const { return m_bytes.size() - m_position; }
    /// Everything was there, and nothing is left over.
    bool finished() const { return !m_failed && left() == 0; }

    quint8 u8() { return quint8(number(1)); }
    quint16 u16() { return quint16(number(2)); }
    quint32 u24() { return number(3); }
    quint32 u32() { return number(4); }
    QByteArray bytes(qsizetype size)
    {
        const QByteArrayView taken = take(size);
        return QByteArray(taken.data(), taken.size());
    }
    QByteArray rest() { return bytes(left()); }
    void skip(qsizetype size) { take(size); }

private:
    QByteArrayView take(qsizetype size)
    {
        if (m_failed || size < 0 || size > left()) {
            m_failed = true;
            return {};
        }
        const QByteArrayView taken = m_bytes.sliced(m_position, size);
        m_position += size;
        return taken;
    }
    quint32 number(int size)
    {
        quint32 value = 0;
        const QByteArrayView taken = take(size);
        for (qsizetype i = 0; i < taken.size(); ++i)
            value |= quint32(quint8(taken[i])) << (8 * i);
        return value;
    }

    QByteArrayView m_bytes;
    qsizetype m_position = 0;
    bool m_failed = false;
};

} // namespace lds::slmp

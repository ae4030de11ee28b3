#include "line_transmitter.h"

#include <algorithm>

namespace lds::emulator {

namespace {

/// Bytes reach the client in portions of about this time: as a line does, without waking it for each.
constexpr qint64 portionNs = 1'000'000;

/// What a receiver makes of a character at another speed or parity: never what was sent, since turning a
/// byte changes an even number of its bits and the constant an odd one.
char garbled(char byte)
{
    const unsigned bits = quint8(byte);
    return char((bits << 1 | bits >> 7) ^ 0x57U);
}

} // namespace

LineTransmitter::LineTransmitter(LineTerminal& terminal, EmulatorClock& clock)
    : m_terminal(terminal)
    , m_clock(clock)
{}

void LineTransmitter::send(const QByteArray& bytes, LineSettings settings, qint64 startNs)
{
    if (m_burst) {
        const qint64 begun = std::max(charactersUntil(startNs), m_burst->delivered);
        m_burst->bytes.resize(std::max(m_burst->bytes.size(), begun + bytes.size()), '\xff');
        mix(bytes, begun);
        ++m_burst->senders;
    } else {
        m_burst = Burst{bytes, settings, startNs};
    }
    deliverDue();
}

void LineTransmitter::disturb(const QByteArray& bytes, qint64 startNs)
{
    if (m_burst)
        mix(bytes, charactersUntil(startNs));
}

void LineTransmitter::cut()
{
    if (!m_burst)
        return;
    m_burst->bytes.truncate(std::max(m_burst->delivered, charactersUntil(m_clock.nowNs())));
    deliverDue();
}

/// Two drivers on one pair of wires: a 0 of either wins. They are never bit by bit at the same time, so that
/// two equal answers spoil each other as well.
void LineTransmitter::mix(const QByteArray& bytes, qsizetype from)
{
    QByteArray& line = m_burst->bytes;
    unsigned before = 0;
    for (qsizetype i = 0; i < bytes.size() && from + i < line.size(); ++i) {
        const unsigned bits = quint8(bytes.at(i));
        const auto shifted = char(bits << 3 | before >> 5);
        before = bits;
        if (from + i >= m_burst->delivered) // the rest has gone out
            line[from + i] = char(line.at(from + i) & shifted);
    }
}

/// Of the burst, those that are over.
qsizetype LineTransmitter::charactersUntil(qint64 timeNs) const
{
    const modbus::RtuRate rate = m_burst->settings.rate();
    const qint64 since = std::max<qint64>(timeNs - m_burst->startNs, 0);
    auto count = since / modbus::charactersNs(rate, 1); // a little too few, since one is rounded up
    while (modbus::charactersNs(rate, count + 1) <= since)
        ++count;
    return count;
}

void LineTransmitter::deliverDue()
{
    m_clock.cancel(m_timer);
    m_timer = 0;
    const qsizetype over = std::min(charactersUntil(m_clock.nowNs()), m_burst->bytes.size());
    QByteArray portion = m_burst->bytes.sliced(m_burst->delivered, over - m_burst->delivered);
    if (!portion.isEmpty()) {
        if (m_terminal.clientSettings() != m_burst->settings)
            std::transform(portion.cbegin(), portion.cend(), portion.begin(), garbled);
        m_burst->delivered = over;
        m_terminal.send(portion);
    }
    if (m_burst->delivered < m_burst->bytes.size()) {
        waitForMore();
        return;
    }
    m_burst.reset();
    Q_EMIT finished();
}

void LineTransmitter::waitForMore()
{
    const modbus::RtuRate rate = m_burst->settings.rate();
    const qint64 portion = std::max<qint64>(1, portionNs / modbus::charactersNs(rate, 1));
    const qint64 next = std::min<qint64>(m_burst->delivered + portion, m_burst->bytes.size());
    m_timer = m_clock.at(m_burst->startNs + modbus::charactersNs(rate, next), this, [this] {
        m_timer = 0;
        deliverDue();
    });
}

} // namespace lds::emulator

#pragma once

#include <QByteArray>
#include <QList>

namespace lds::emulator {

/// Finds the messages in what arrives over TCP, as §5.2.3 judges them. A message is what arrives: bytes
/// that add up to whole messages are those messages; bytes that do not are waited with until the line
/// pauses, and then discarded. Never holds more than one read of the socket.
class ModbusMessageBuffer {
public:
    enum class State {
        Empty,    ///< All that arrived was taken, or discarded.
        Waiting,  ///< Does not add up yet: discard() when the line has paused.
        Overlong, ///< More than 270 bytes: the connection ends.
    };

    /// Appends what arrived; `messages` gets the whole messages that are to be answered, in order.
    State feed(const QByteArray& bytes, QList<QByteArray>& messages);
    void discard() { m_bytes.clear(); }

private:
    QByteArray m_bytes;
};

} // namespace lds::emulator

#pragma once

#include <QByteArray>
#include <QMetaType>
#include <QString>
#include <QStringList>

namespace lds::ports {

enum class Direction : quint8 { Sent, Received };

/// What a message means, in a code and arguments that ui/ turns into a sentence in the person's language.
enum class FrameMeaning : quint8 {
    Connecting, ///< arguments: host, port
    Connected,
    Disconnected, ///< arguments: reason
    Read,         ///< arguments: first and last register as printed, "400101", "400171"
    ReadCoils,    ///< arguments: first and last coil
    Write,        ///< arguments: first and last register, values as text
    Answer,       ///< arguments: first and last register, values as text; the read's answer
    AnswerCoils,
    Written,   ///< arguments: first and last register
    Refused,   ///< arguments: function code, exception code
    NoAnswer,  ///< arguments: milliseconds waited; stands for the message that did not come
    Malformed, ///< arguments: what is wrong (stable word: "short", "length", "function", ...)
    Unknown,
};

/// One message on the wire, for the messages page. Every link feeds the same log.
struct Frame {
    qint64 monotonicNs = 0;
    qint64 wallMs = 0;
    Direction direction = Direction::Sent;
    FrameMeaning meaning = FrameMeaning::Unknown;
    QStringList arguments;
    QByteArray bytes; ///< As they went over the wire, as far as known.
    int reconstructedPrefix =
        0;                   ///< This many leading bytes were not seen but rebuilt (QModbus shows PDUs only).
    qint64 roundTripNs = -1; ///< On an answer: since its request; −1 elsewhere.
    QString protocol;        ///< "Modbus TCP"
    QString peer;            ///< The link's URL without parameters: tells the sensors apart.
};

/// Takes frames from links. Implementations may be called from any thread and must not block.
class FrameLog {
public:
    virtual ~FrameLog() = default;
    virtual void record(const Frame& frame) = 0;
};

} // namespace lds::ports
Q_DECLARE_METATYPE(lds::ports::Frame)

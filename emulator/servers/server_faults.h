#pragma once

#include <optional>
#include <QList>
#include <QtGlobal>

namespace lds::emulator {

/// Ways in which an answer goes wrong on purpose.
enum class Fault : quint8 {
    IgnoreRequest, ///< Neither carried out nor answered.
    DropAnswer,    ///< Carried out, not answered.
    CutAnswer,     ///< Carried out; the last two bytes of the answer never come.
    // Over TCP only.
    WrongTransaction,    ///< Carried out; answered under another transaction identifier.
    CloseBeforeCarryOut, ///< The connection ends instead.
    CloseAfterCarryOut,  ///< Carried out; the connection ends instead of an answer.
    // On a serial line only.
    FlipBit,     ///< Carried out; one bit in the middle of the answer is another.
    LoseByte,    ///< Carried out; a byte in the middle of the answer never comes.
    NoiseBefore, ///< Carried out; three stray bytes come right before the answer.
    OtherUnit,   ///< Carried out; the answer, without a fault, comes from another unit.
};

enum class FaultOn : quint8 { AnyRequest, Reads, Writes };

/// Faults waiting for the requests they are meant for, each used up once.
class ServerFaults {
public:
    void add(Fault fault, FaultOn on, int times);
    void clear() { m_waiting.clear(); }
    int waiting() const { return int(m_waiting.size()); }

    /// Takes the first fault meant for a request with this function code.
    std::optional<Fault> take(quint8 functionCode);

private:
    struct Waiting {
        Fault fault;
        FaultOn on;
    };
    QList<Waiting> m_waiting;
};

} // namespace lds::emulator

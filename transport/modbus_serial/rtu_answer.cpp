#include "rtu_answer.h"

#include "modbus_rtu_framing.h"

#include <optional>

namespace lds::modbus {

namespace {

constexpr quint8 exceptionFlag = 0x80;

/// The whole length of the answer that begins with these bytes; −1 when more are needed to tell, 0 when no
/// answer begins like this.
qsizetype answerLength(const QByteArray& bytes)
{
    constexpr int exceptionLength = 5;
    constexpr int echoLength = 8;
    if (bytes.size() < 2)
        return -1;
    const auto function = quint8(bytes.at(1));
    if (function & exceptionFlag)
        return exceptionLength;
    switch (Function(function)) {
    case Function::ReadCoils:
    case Function::ReadHoldingRegisters:
        return bytes.size() < 3 ? -1 : 3 + quint8(bytes.at(2)) + 2;
    case Function::WriteSingleRegister:
    case Function::WriteMultipleRegisters:
        return echoLength;
    }
    return 0;
}

struct Cut {
    QList<QByteArray> messages; ///< Whole, with a good CRC.
    QByteArray rest;            ///< From the first byte that belongs to none.
    QString what;               ///< Why the rest is none: "short" or "noise".
};

/// A bad CRC leaves nobody to say where the next message begins.
Cut cut(const QByteArray& heard)
{
    Cut result;
    result.rest = heard;
    while (!result.rest.isEmpty()) {
        const qsizetype length = answerLength(result.rest);
        if (length < 0 || length > result.rest.size()) {
            result.what = QStringLiteral("short");
            break;
        }
        if (length == 0 || !decodeRtuFrame(result.rest.first(length))) {
            result.what = QStringLiteral("noise");
            break;
        }
        result.messages.append(result.rest.first(length));
        result.rest.remove(0, length);
    }
    return result;
}

quint8 unitOf(const QByteArray& message) { return quint8(message.at(0)); }

bool isCoils(const QByteArray& message)
{
    return (quint8(message.at(1)) & ~exceptionFlag) == quint8(Function::ReadCoils);
}

RtuVerdict spoiled(RtuVerdict verdict, const QByteArray& bytes, const QString& what)
{
    verdict.kind = RtuVerdict::Kind::Spoiled;
    verdict.what = what;
    verdict.frame.clear();
    verdict.strays.append({bytes, what});
    return verdict;
}

/// `mayBeLate` says which messages of the unit asked cannot be the answer.
template <typename MayBeLate>
RtuVerdict judge(const QByteArray& heard, quint8 unit, const MayBeLate& mayBeLate)
{
    const Cut cuts = cut(heard);
    RtuVerdict verdict;
    std::optional<QByteArray> second;
    for (const QByteArray& message : cuts.messages) {
        if (unitOf(message) != unit)
            verdict.strays.append({message, QStringLiteral("unit")});
        else if (mayBeLate(message))
            verdict.strays.append({message, QStringLiteral("late")});
        else if (verdict.kind == RtuVerdict::Kind::Answer)
            second = message;
        else {
            verdict.kind = RtuVerdict::Kind::Answer;
            verdict.frame = message;
        }
    }
    // Two messages that could be the answer: nobody can tell which one is.
    if (second)
        return spoiled(verdict, verdict.frame + *second, QStringLiteral("trailing"));
    if (cuts.rest.isEmpty())
        return verdict;
    if (verdict.kind == RtuVerdict::Kind::Answer)
        return spoiled(verdict, verdict.frame + cuts.rest, QStringLiteral("trailing"));
    return spoiled(verdict, cuts.rest, cuts.what);
}

} // namespace

RtuVerdict judgeData(const QByteArray& heard, quint8 unit)
{
    return judge(heard, unit, [](const QByteArray& message) { return isCoils(message); });
}

RtuVerdict judgeCoils(const QByteArray& heard, quint8 unit)
{
    return judge(heard, unit, [](const QByteArray& message) { return !isCoils(message); });
}

} // namespace lds::modbus

#pragma once

#include <QByteArray>
#include <QList>
#include <QtGlobal>
#include <tl/expected.hpp>

/// Modbus protocol data units of the four functions the HL-G2 supports (§5.2.3), as pure functions.
/// Every decoder treats its bytes as hostile: bounded, no exceptions, no allocation beyond the message.
namespace lds::modbus {

enum class Function : quint8 {
    ReadCoils = 0x01,
    ReadHoldingRegisters = 0x03,
    WriteSingleRegister = 0x06,
    WriteMultipleRegisters = 0x10,
};

/// Whether a request with this function code changes something.
constexpr bool isWrite(quint8 functionCode)
{
    return functionCode == quint8(Function::WriteSingleRegister) ||
           functionCode == quint8(Function::WriteMultipleRegisters);
}

/// Error codes of §5.2.2.
enum class Exception : quint8 {
    FunctionCode = 0x01,
    Address = 0x02,
    Data = 0x03,
    Other = 0x04,
};

inline constexpr int maximumCoils = 2000;         ///< FC 01
inline constexpr int maximumReadRegisters = 125;  ///< FC 03
inline constexpr int maximumWriteRegisters = 123; ///< FC 10h

struct Request {
    Function function = Function::ReadHoldingRegisters;
    quint16 address = 0;      ///< As on the wire: register − 400001, coil − 1.
    quint16 count = 0;        ///< Coils or registers; 1 for WriteSingleRegister.
    QList<quint16> registers; ///< Values to write.
};

struct Response {
    Function function = Function::ReadHoldingRegisters;
    quint16 address = 0; ///< Echoed by the write functions, taken from the request otherwise.
    quint16 count = 0;
    QList<quint16> registers; ///< FC 03, and the echoed value of FC 06.
    QList<bool> coils;        ///< FC 01, exactly `count`.
};

QByteArray encodeRequest(const Request& request);
/// A server's view: which exception to answer with when the message is not a legal request (§5.2.2, in the
/// order function code, then length, count and number of bytes).
tl::expected<Request, Exception> decodeRequest(const QByteArray& pdu);

QByteArray encodeResponse(const Response& response);
QByteArray encodeException(quint8 functionCode, Exception exception);

enum class ResponseError {
    Empty,
    Refused,  ///< The sensor's exception: see `exceptionCode`.
    Function, ///< The answer to another function.
    Length,   ///< Cut short, too long, or a byte count that does not fit the request.
    Echo,     ///< A write's echo names another address, count or value.
};
struct ResponseFailure {
    ResponseError error;
    quint8 exceptionCode = 0; ///< As received; may be none of Exception.
};
/// A client's view: the answer to `request` and to nothing else.
tl::expected<Response, ResponseFailure> decodeResponse(const Request& request, const QByteArray& pdu);

/// Two registers as one signed 32-bit value.
qint32 toInt32(quint16 first, quint16 second, bool lowWordFirst);
QList<quint16> fromInt32(qint32 value, bool lowWordFirst);

} // namespace lds::modbus

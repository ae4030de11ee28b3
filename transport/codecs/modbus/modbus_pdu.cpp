#include "modbus_pdu.h"

#include <QtEndian>

namespace lds::modbus {

namespace {

constexpr int shortRequestSize = 5;       ///< Function 1, address 2, count or value 2.
constexpr int writeRequestHeaderSize = 6; ///< Function 1, address 2, count 2, number of bytes 1.
constexpr quint8 exceptionFlag = 0x80;

void appendWord(QByteArray& bytes, quint16 word)
{
    bytes.append(char(word >> 8));
    bytes.append(char(word & 0xff));
}

quint8 byteAt(const QByteArray& bytes, qsizetype index) { return quint8(bytes.at(index)); }

/// The caller has checked that two bytes are there.
quint16 wordAt(const QByteArray& bytes, qsizetype index)
{
    return qFromBigEndian<quint16>(bytes.constData() + index);
}

QList<quint16> wordsAt(const QByteArray& bytes, qsizetype index, int count)
{
    QList<quint16> words;
    words.reserve(count);
    for (int i = 0; i < count; ++i)
        words.append(wordAt(bytes, index + 2 * i));
    return words;
}

int coilBytes(int coils) { return (coils + 7) / 8; }

QByteArray packCoils(const QList<bool>& coils)
{
    QByteArray bytes(coilBytes(int(coils.size())), '\0');
    for (qsizetype i = 0; i < coils.size(); ++i) {
        if (coils.at(i))
            bytes[i / 8] = char(quint8(bytes.at(i / 8)) | (1U << (i % 8)));
    }
    return bytes;
}

QList<bool> unpackCoils(const QByteArray& bytes, qsizetype index, int count)
{
    QList<bool> coils;
    coils.reserve(count);
    for (int i = 0; i < count; ++i)
        coils.append((byteAt(bytes, index + i / 8) >> (i % 8)) & 1);
    return coils;
}

tl::expected<Request, Exception> decodeRead(Function function, const QByteArray& pdu, int maximum)
{
    if (pdu.size() != shortRequestSize)
        return tl::unexpected(Exception::Data);
    const quint16 count = wordAt(pdu, 3);
    if (count < 1 || count > maximum)
        return tl::unexpected(Exception::Data);
    return Request{function, wordAt(pdu, 1), count, {}};
}

tl::expected<Request, Exception> decodeWriteSingle(const QByteArray& pdu)
{
    if (pdu.size() != shortRequestSize)
        return tl::unexpected(Exception::Data);
    return Request{Function::WriteSingleRegister, wordAt(pdu, 1), 1, {wordAt(pdu, 3)}};
}

tl::expected<Request, Exception> decodeWriteMultiple(const QByteArray& pdu)
{
    if (pdu.size() < writeRequestHeaderSize)
        return tl::unexpected(Exception::Data);
    const quint16 count = wordAt(pdu, 3);
    if (count < 1 || count > maximumWriteRegisters)
        return tl::unexpected(Exception::Data);
    if (byteAt(pdu, 5) != 2 * count || pdu.size() != writeRequestHeaderSize + 2 * count)
        return tl::unexpected(Exception::Data);
    return Request{Function::WriteMultipleRegisters, wordAt(pdu, 1), count,
                   wordsAt(pdu, writeRequestHeaderSize, count)};
}

using DecodedResponse = tl::expected<Response, ResponseFailure>;

tl::unexpected<ResponseFailure> failure(ResponseError error, quint8 code = 0)
{
    return tl::unexpected(ResponseFailure{error, code});
}

DecodedResponse decodeReadResponse(const Request& request, const QByteArray& pdu)
{
    const bool coils = request.function == Function::ReadCoils;
    const int dataBytes = coils ? coilBytes(request.count) : 2 * request.count;
    if (pdu.size() != 2 + dataBytes || byteAt(pdu, 1) != dataBytes)
        return failure(ResponseError::Length);
    Response response{request.function, request.address, request.count, {}, {}};
    if (coils)
        response.coils = unpackCoils(pdu, 2, request.count);
    else
        response.registers = wordsAt(pdu, 2, request.count);
    return response;
}

DecodedResponse decodeWriteResponse(const Request& request, const QByteArray& pdu)
{
    if (pdu.size() != shortRequestSize)
        return failure(ResponseError::Length);
    const bool single = request.function == Function::WriteSingleRegister;
    const quint16 expected = single ? request.registers.value(0) : quint16(request.registers.size());
    if (wordAt(pdu, 1) != request.address || wordAt(pdu, 3) != expected)
        return failure(ResponseError::Echo);
    Response response{request.function, request.address, request.count, {}, {}};
    if (single)
        response.registers = {expected};
    return response;
}

} // namespace

QByteArray encodeRequest(const Request& request)
{
    QByteArray pdu;
    pdu.append(char(request.function));
    appendWord(pdu, request.address);
    switch (request.function) {
    case Function::ReadCoils:
    case Function::ReadHoldingRegisters:
        appendWord(pdu, request.count);
        break;
    case Function::WriteSingleRegister:
        appendWord(pdu, request.registers.value(0));
        break;
    case Function::WriteMultipleRegisters:
        appendWord(pdu, quint16(request.registers.size()));
        pdu.append(char(2 * request.registers.size()));
        for (const quint16 word : request.registers)
            appendWord(pdu, word);
        break;
    }
    return pdu;
}

tl::expected<Request, Exception> decodeRequest(const QByteArray& pdu)
{
    if (pdu.isEmpty())
        return tl::unexpected(Exception::FunctionCode);
    switch (Function(byteAt(pdu, 0))) {
    case Function::ReadCoils:
        return decodeRead(Function::ReadCoils, pdu, maximumCoils);
    case Function::ReadHoldingRegisters:
        return decodeRead(Function::ReadHoldingRegisters, pdu, maximumReadRegisters);
    case Function::WriteSingleRegister:
        return decodeWriteSingle(pdu);
    case Function::WriteMultipleRegisters:
        return decodeWriteMultiple(pdu);
    }
    return tl::unexpected(Exception::FunctionCode);
}

QByteArray encodeResponse(const Response& response)
{
    QByteArray pdu;
    pdu.append(char(response.function));
    switch (response.function) {
    case Function::ReadCoils: {
        const QByteArray bytes = packCoils(response.coils);
        pdu.append(char(bytes.size()));
        pdu.append(bytes);
        break;
    }
    case Function::ReadHoldingRegisters:
        pdu.append(char(2 * response.registers.size()));
        for (const quint16 word : response.registers)
            appendWord(pdu, word);
        break;
    case Function::WriteSingleRegister:
        appendWord(pdu, response.address);
        appendWord(pdu, response.registers.value(0));
        break;
    case Function::WriteMultipleRegisters:
        appendWord(pdu, response.address);
        appendWord(pdu, response.count);
        break;
    }
    return pdu;
}

QByteArray encodeException(quint8 functionCode, Exception exception)
{
    QByteArray pdu;
    pdu.append(char(functionCode | exceptionFlag));
    pdu.append(char(exception));
    return pdu;
}

tl::expected<Response, ResponseFailure> decodeResponse(const Request& request, const QByteArray& pdu)
{
    if (pdu.isEmpty())
        return failure(ResponseError::Empty);
    const quint8 functionCode = byteAt(pdu, 0);
    if (functionCode == (quint8(request.function) | exceptionFlag)) {
        if (pdu.size() != 2)
            return failure(ResponseError::Length);
        return failure(ResponseError::Refused, byteAt(pdu, 1));
    }
    if (functionCode != quint8(request.function))
        return failure(ResponseError::Function);
    switch (request.function) {
    case Function::ReadCoils:
    case Function::ReadHoldingRegisters:
        return decodeReadResponse(request, pdu);
    case Function::WriteSingleRegister:
    case Function::WriteMultipleRegisters:
        return decodeWriteResponse(request, pdu);
    }
    return failure(ResponseError::Function);
}

qint32 toInt32(quint16 first, quint16 second, bool lowWordFirst)
{
    const quint16 low = lowWordFirst ? first : second;
    const quint16 high = lowWordFirst ? second : first;
    return qint32((quint32(high) << 16) | low);
}

QList<quint16> fromInt32(qint32 value, bool lowWordFirst)
{
    const auto low = quint16(quint32(value) & 0xffff);
    const auto high = quint16(quint32(value) >> 16);
    return lowWordFirst ? QList<quint16>{low, high} : QList<quint16>{high, low};
}

} // namespace lds::modbus

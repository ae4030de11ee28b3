#include "modbus_responder.h"

#include <algorithm>

namespace lds::emulator {

using namespace catalog;
using modbus::Exception;
using modbus::Function;
using modbus::Request;
using modbus::Response;

namespace {

constexpr int coilCount = 64; ///< §5.2.5; coil 1 has address 0.

Exception exceptionFor(Refusal refusal)
{
    switch (refusal) {
    case Refusal::Data:
        return Exception::Data;
    case Refusal::NotReady:
    case Refusal::Failed:
        return Exception::Other;
    }
    return Exception::Other;
}

} // namespace

ModbusResponder::ModbusResponder(VirtualSensor& sensor)
    : m_sensor(sensor)
{}

QByteArray ModbusResponder::answer(const QByteArray& pdu)
{
    const quint8 functionCode = pdu.isEmpty() ? 0 : quint8(pdu.at(0));
    const auto request = modbus::decodeRequest(pdu);
    if (!request)
        return modbus::encodeException(functionCode, request.error());
    if (!m_sensor.isReady())
        return modbus::encodeException(functionCode, Exception::Other);
    m_sensor.catchUp();
    const Answer carriedOut = carryOut(*request);
    if (!carriedOut)
        return modbus::encodeException(functionCode, carriedOut.error());
    return modbus::encodeResponse(*carriedOut);
}

ModbusResponder::Answer ModbusResponder::carryOut(const Request& request)
{
    switch (request.function) {
    case Function::ReadCoils:
        return readCoils(request);
    case Function::ReadHoldingRegisters:
        return readRegisters(request);
    case Function::WriteSingleRegister:
        return writeSingle(request);
    case Function::WriteMultipleRegisters:
        return writeMultiple(request);
    }
    return tl::unexpected(Exception::FunctionCode);
}

/// Coils that do not exist read as 0; reserved ones are coils all the same.
ModbusResponder::Answer ModbusResponder::readCoils(const Request& request)
{
    if (request.address >= coilCount)
        return tl::unexpected(Exception::Address);
    Response response{request.function, request.address, request.count, {}, {}};
    for (int i = 0; i < request.count; ++i)
        response.coils.append(m_sensor.coil(request.address + i + 1));
    return response;
}

ModbusResponder::Answer ModbusResponder::readRegisters(const Request& request)
{
    Response response{request.function, request.address, request.count, {}, {}};
    int successful = 0;
    for (int i = 0; i < request.count; ++i) {
        const auto place = m_map.at(request.address + i);
        const bool readable = place.item && place.item->isReadable();
        successful += readable;
        response.registers.append(readable ? registerValue(place) : quint16(0));
    }
    if (successful == 0)
        return tl::unexpected(Exception::Address);
    return response;
}

quint16 ModbusResponder::registerValue(const ModbusRegisterMap::Place& place) const
{
    const Value value = m_sensor.read(place.item->id);
    if (place.item->size == 4)
        return modbus::fromInt32(value, m_lowWordFirst).at(place.word);
    return quint16(value);
}

ModbusResponder::Answer ModbusResponder::writeSingle(const Request& request)
{
    const auto place = m_map.at(request.address);
    if (!place.item || !place.item->isWritable())
        return tl::unexpected(Exception::Address);
    const quint16 value = request.registers.first();
    if (place.item->size == 4 || (place.item->size == 1 && value > 0xff))
        return tl::unexpected(Exception::Data);
    const WriteOutcome outcome = m_sensor.write({{place.item->id, value}});
    if (outcome.refusal)
        return tl::unexpected(exceptionFor(*outcome.refusal));
    return Response{request.function, request.address, 1, request.registers, {}};
}

ModbusResponder::Answer ModbusResponder::writeMultiple(const Request& request)
{
    const auto writes = collectWrites(request);
    if (!writes)
        return tl::unexpected(writes.error());
    if (writes->isEmpty())
        return tl::unexpected(Exception::Address);
    const WriteOutcome outcome = m_sensor.write(*writes);
    if (outcome.refusal)
        return tl::unexpected(exceptionFor(*outcome.refusal));
    return Response{request.function, request.address, request.count, {}, {}};
}

tl::expected<QList<ItemWrite>, Exception> ModbusResponder::collectWrites(const Request& request) const
{
    for (int i = 0; i < request.count; ++i) {
        if (m_map.at(request.address + i).prohibited)
            return tl::unexpected(Exception::Address);
    }
    QList<ItemWrite> writes;
    for (int i = 0; i < request.count; ++i) {
        const auto place = m_map.at(request.address + i);
        if (!place.item || !place.item->isWritable())
            continue; // skipped, and not counted (§5.2.3)
        const quint16 value = request.registers.at(i);
        if (place.item->size != 4) {
            if (place.item->size == 1 && value > 0xff)
                return tl::unexpected(Exception::Data);
            writes.append({place.item->id, value});
            continue;
        }
        if (place.word != 0 || i + 1 >= request.count)
            return tl::unexpected(Exception::Data); // only half of a 4-byte item
        writes.append({place.item->id, modbus::toInt32(value, request.registers.at(i + 1), m_lowWordFirst)});
        ++i;
    }
    return writes;
}

} // namespace lds::emulator

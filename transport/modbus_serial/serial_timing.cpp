#include "serial_timing.h"

namespace lds::modbus {

namespace {

constexpr qint64 nsPerMs = 1'000'000;
constexpr int unitAndCrc = 3;

} // namespace

RtuRate rateOf(const ports::SerialSettings& settings) { return {settings.baud, settings.bitsPerCharacter()}; }

int requestBytes(const Request& request) { return unitAndCrc + int(encodeRequest(request).size()); }

int answerBytes(const Request& request)
{
    switch (request.function) {
    case Function::ReadCoils:
        return unitAndCrc + 2 + (request.count + 7) / 8;
    case Function::ReadHoldingRegisters:
        return unitAndCrc + 2 + 2 * request.count;
    case Function::WriteSingleRegister:
    case Function::WriteMultipleRegisters:
        break;
    }
    return unitAndCrc + 5;
}

qint64 shortestExchangeNs(const ports::SerialSettings& settings, const Request& request, qint64 answeringNs)
{
    const RtuRate rate = rateOf(settings);
    return charactersNs(rate, requestBytes(request)) + answeringNs +
           charactersNs(rate, answerBytes(request)) + 2 * frameSilenceNs(rate);
}

int timeoutMs(const ports::SerialSettings& settings, const Request& request, int answeringMs)
{
    const qint64 lineNs = shortestExchangeNs(settings, request);
    return answeringMs + adapterDelayMs + int((lineNs + nsPerMs - 1) / nsPerMs);
}

qint64 quietNs(const ports::SerialSettings& settings)
{
    return frameSilenceNs(rateOf(settings)) + adapterDelayMs * nsPerMs;
}

} // namespace lds::modbus

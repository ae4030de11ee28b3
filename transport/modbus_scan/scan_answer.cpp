#include "scan_answer.h"

#include "item_registers.h"
#include "modbus_pdu.h"
#include "modbus_rtu_framing.h"

#include <optional>

namespace lds::modbus {

namespace {

constexpr qsizetype mostStrayBytes = 2;

Request spanRequest() { return readRequest(packReads({catalog::ItemId::Span}).constFirst()); }

/// Nothing when it does not answer the request at all.
std::optional<AnswerKind> kindOf(const QByteArray& pdu)
{
    const auto response = decodeResponse(spanRequest(), pdu);
    if (response) {
        const bool isSpan =
            lowWordFirstBySpan(response->registers.at(0), response->registers.at(1)).has_value();
        return isSpan ? AnswerKind::Sensor : AnswerKind::OtherDevice;
    }
    if (response.error().error != ResponseError::Refused)
        return std::nullopt;
    const bool notReady = response.error().exceptionCode == quint8(Exception::Other);
    return notReady ? AnswerKind::NotReady : AnswerKind::OtherDevice;
}

/// The answer of some unit to the request, and nothing around it.
std::optional<ScanAnswer> judgeFrame(quint8 asked, const QByteArray& bytes)
{
    const auto frame = decodeRtuFrame(bytes);
    if (!frame || frame->unit < firstRtuUnit || frame->unit > lastRtuUnit)
        return std::nullopt;
    const auto kind = kindOf(frame->pdu);
    if (!kind)
        return std::nullopt;
    if (frame->unit == asked)
        return ScanAnswer{*kind, asked, AnswerKind::Silence};
    return ScanAnswer{AnswerKind::OtherUnit, frame->unit, *kind};
}

} // namespace

QByteArray scanRequest(quint8 unit) { return encodeRtuFrame(unit, encodeRequest(spanRequest())); }

ScanAnswer judgeScanAnswer(quint8 unit, const QByteArray& bytes)
{
    const QByteArray request = scanRequest(unit);
    const QByteArray heard = bytes.startsWith(request) ? bytes.sliced(request.size()) : bytes;
    if (heard.isEmpty())
        return {};
    for (qsizetype stray = 0; stray <= std::min(mostStrayBytes, heard.size() - 1); ++stray) {
        for (qsizetype before = 0; before <= stray; ++before) {
            const QByteArray part = heard.sliced(before, heard.size() - stray);
            if (const auto answer = judgeFrame(unit, part))
                return *answer;
        }
    }
    // Of another unit it would be talk between others, and this no line to scan.
    const auto frame = decodeRtuFrame(heard);
    if (frame && frame->unit == unit)
        return {AnswerKind::OtherDevice, unit, AnswerKind::Silence};
    return {AnswerKind::Garbage, 0, AnswerKind::Silence};
}

} // namespace lds::modbus

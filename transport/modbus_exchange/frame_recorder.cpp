#include "frame_recorder.h"

namespace lds::modbus {

using ports::Direction;
using ports::FrameMeaning;

namespace {

QString placeOf(const ports::ConnectionUrl& url)
{
    if (url.protocol == ports::Protocol::ModbusTcp)
        return QString::number(url.port);
    const char* const parity = url.serial.parity == ports::SerialParity::None   ? "none"
                               : url.serial.parity == ports::SerialParity::Even ? "even"
                                                                                : "odd";
    return QStringLiteral("%1 bps, %2, %3")
        .arg(url.serial.baud)
        .arg(QLatin1StringView(parity))
        .arg(url.serial.stopBits());
}

FrameMeaning sentMeaning(Function function)
{
    switch (function) {
    case Function::ReadCoils:
        return FrameMeaning::ReadCoils;
    case Function::ReadHoldingRegisters:
        return FrameMeaning::Read;
    case Function::WriteSingleRegister:
    case Function::WriteMultipleRegisters:
        break;
    }
    return FrameMeaning::Write;
}

FrameMeaning answeredMeaning(Function function)
{
    switch (function) {
    case Function::ReadCoils:
        return FrameMeaning::AnswerCoils;
    case Function::ReadHoldingRegisters:
        return FrameMeaning::Answer;
    case Function::WriteSingleRegister:
    case Function::WriteMultipleRegisters:
        break;
    }
    return FrameMeaning::Written;
}

QString coilTexts(int firstCoil, const QList<bool>& coils)
{
    QStringList texts;
    for (qsizetype i = 0; i < coils.size(); ++i)
        texts.append(QStringLiteral("%1=%2").arg(firstCoil + i).arg(int(coils.at(i))));
    return texts.join(QLatin1String(", "));
}

bool isWrite(const Request& request)
{
    return request.function == Function::WriteSingleRegister ||
           request.function == Function::WriteMultipleRegisters;
}

} // namespace

FrameRecorder::FrameRecorder(ports::FrameLog& log, const ports::Scheduler& clock,
                             const ports::ConnectionUrl& url)
    : m_log(log)
    , m_clock(clock)
    , m_host(url.host)
    , m_port(placeOf(url))
    , m_protocol(url.protocol == ports::Protocol::ModbusTcp ? QStringLiteral("Modbus TCP")
                                                            : QStringLiteral("Modbus RTU"))
    , m_peer(url.peer().toString())
{}

void FrameRecorder::connecting() { record(Direction::Sent, FrameMeaning::Connecting, {m_host, m_port}); }

void FrameRecorder::connected() { record(Direction::Received, FrameMeaning::Connected, {}); }

void FrameRecorder::disconnected(const QString& reason)
{
    record(Direction::Received, FrameMeaning::Disconnected, {reason});
}

void FrameRecorder::sent(const Request& request, const QByteArray& bytes, int reconstructedPrefix)
{
    QStringList arguments = range(request);
    if (isWrite(request))
        arguments.append(values(request, request.registers));
    record(Direction::Sent, sentMeaning(request.function), arguments, bytes, -1, reconstructedPrefix);
}

void FrameRecorder::answered(const Request& request, const Response& response, const QByteArray& bytes,
                             qint64 roundTripNs)
{
    QStringList arguments = range(request);
    if (request.function == Function::ReadCoils)
        arguments.append(coilTexts(request.address + 1, response.coils));
    else if (!isWrite(request))
        arguments.append(values(request, response.registers));
    record(Direction::Received, answeredMeaning(request.function), arguments, bytes, roundTripNs);
}

void FrameRecorder::refused(const Request& request, quint8 exceptionCode, const QByteArray& bytes,
                            qint64 roundTripNs)
{
    record(Direction::Received, FrameMeaning::Refused,
           {QString::number(int(request.function)), QString::number(exceptionCode)}, bytes, roundTripNs);
}

void FrameRecorder::malformed(const QString& what, const QByteArray& bytes, qint64 roundTripNs)
{
    record(Direction::Received, FrameMeaning::Malformed, {what}, bytes, roundTripNs);
}

void FrameRecorder::noAnswer(qint64 waitedNs)
{
    record(Direction::Received, FrameMeaning::NoAnswer, {QString::number(waitedNs / 1'000'000)});
}

void FrameRecorder::record(Direction direction, FrameMeaning meaning, const QStringList& arguments,
                           const QByteArray& bytes, qint64 roundTripNs, int reconstructedPrefix)
{
    ports::Frame frame;
    frame.monotonicNs = m_clock.nowNs();
    frame.wallMs = m_clock.wallMs();
    frame.direction = direction;
    frame.meaning = meaning;
    frame.arguments = arguments;
    frame.bytes = bytes;
    frame.reconstructedPrefix = reconstructedPrefix;
    frame.roundTripNs = roundTripNs;
    frame.protocol = m_protocol;
    frame.peer = m_peer;
    m_log.record(frame);
}

QStringList FrameRecorder::range(const Request& request) const
{
    const int last = request.address + request.count - 1;
    if (request.function == Function::ReadCoils) // Coils are numbered from 1 (§6.3.4).
        return {QString::number(request.address + 1), QString::number(last + 1)};
    return {QString::number(printedRegister(request.address)), QString::number(printedRegister(last))};
}

QString FrameRecorder::values(const Request& request, const QList<quint16>& registers) const
{
    QString text;
    for (const catalog::SettingItem& item : catalog::Catalog::hlG2().items()) {
        if (!item.modbus || (!isWrite(request) && !item.isReadable()))
            continue;
        const int index = item.modbus->address() - request.address;
        if (index < 0 || index + item.registerCount() > registers.size())
            continue;
        if (!text.isEmpty())
            text += QLatin1String(", ");
        text += QLatin1String(item.key) + QLatin1Char('=');
        text += QString::number(decodeItem(item, registers, index, m_lowWordFirst));
    }
    return text;
}

} // namespace lds::modbus

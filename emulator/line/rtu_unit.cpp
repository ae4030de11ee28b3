#include "rtu_unit.h"

#include <algorithm>
#include <numeric>

namespace lds::emulator {

using catalog::ItemId;

namespace {

constexpr qint64 nanosecondsPerMillisecond = 1'000'000;
constexpr int cutBytes = 2;

LineSettings activeSettings(const VirtualSensor& sensor)
{
    const LineSettings factory;
    return {catalog::lineSpeed(sensor.activeValue(ItemId::CommunicationSpeed)).value_or(factory.speed),
            catalog::lineParity(sensor.activeValue(ItemId::ParityStopBit)).value_or(factory.parity)};
}

/// As the fault spoils it; other faults leave it as it is.
QByteArray spoiled(QByteArray frame, std::optional<Fault> fault)
{
    const qsizetype middle = frame.size() / 2;
    if (fault == Fault::FlipBit)
        frame[middle] = char(frame.at(middle) ^ 0x10);
    else if (fault == Fault::LoseByte)
        frame.remove(middle, 1);
    else if (fault == Fault::NoiseBefore)
        frame.prepend("\xff\x00\xfe", 3);
    return frame;
}

} // namespace

RtuUnit::RtuUnit(VirtualSensor& sensor)
    : m_sensor(sensor)
    , m_responder(sensor)
{
    takeOverSettings();
    connect(&sensor, &VirtualSensor::communicationReset, this, [this] {
        if (!m_answering) // otherwise when the answer has gone out as it was asked for
            takeOverSettings();
    });
    connect(&sensor, &VirtualSensor::poweredOn, this, [this] {
        takeOverSettings();
        Q_EMIT fellSilent();
    });
}

void RtuUnit::takeOverSettings()
{
    m_address = quint8(m_sensor.activeValue(ItemId::DeviceAddress));
    m_settings = activeSettings(m_sensor);
}

bool RtuUnit::takes(const modbus::RtuFrame& frame, LineSettings settings) const
{
    if (m_standing.connectionsDropped || m_answering || settings != m_settings)
        return false;
    if (frame.unit == modbus::broadcastUnit)
        return modbus::isWrite(quint8(frame.pdu.at(0)));
    return frame.unit == m_address;
}

std::optional<RtuUnit::Answer> RtuUnit::hear(const modbus::RtuFrame& frame, LineSettings settings,
                                             qint64 completeNs, qint64 nowNs)
{
    if (!takes(frame, settings))
        return std::nullopt;
    const auto functionCode = quint8(frame.pdu.at(0));
    ++m_requestCounts[functionCode];
    const auto fault = m_faults.take(functionCode);
    if (fault == Fault::IgnoreRequest)
        return std::nullopt;
    if (m_before)
        m_before();
    m_answering = true;
    const QByteArray pdu = m_responder.answer(frame.pdu);
    if (frame.unit == modbus::broadcastUnit || m_standing.answersLost || fault == Fault::DropAnswer) {
        answerGone();
        return std::nullopt;
    }
    const int otherUnit = frame.unit % modbus::lastRtuUnit + 1;
    QByteArray bytes =
        modbus::encodeRtuFrame(fault == Fault::OtherUnit ? quint8(otherUnit) : frame.unit, pdu);
    bytes = spoiled(bytes, fault);
    if (fault == Fault::CutAnswer || m_standing.answersCut)
        bytes.chop(cutBytes);
    const int delayMs = std::max(m_answeringMs, m_standing.answerDelayMs);
    const qint64 silentUntilNs = nowNs + m_sensor.silentForMs() * nanosecondsPerMillisecond;
    const qint64 startNs = completeNs + delayMs * nanosecondsPerMillisecond;
    return Answer{bytes, m_settings, m_sensor.silentForMs() > 0 ? std::max(startNs, silentUntilNs) : startNs};
}

void RtuUnit::answerGone()
{
    m_answering = false;
    takeOverSettings();
}

void RtuUnit::setStandingFaults(const StandingFaults& faults)
{
    m_standing = faults;
    if (m_standing.connectionsDropped)
        Q_EMIT fellSilent();
}

void RtuUnit::injectFault(Fault fault, FaultOn on, int times) { m_faults.add(fault, on, times); }

int RtuUnit::totalRequestCount() const
{
    return std::accumulate(m_requestCounts.begin(), m_requestCounts.end(), 0);
}

} // namespace lds::emulator

// What a virtual sensor answers when it is asked.
#include "virtual_sensor.h"

#include <array>
#include <cstdlib>
#include <numeric>

namespace lds::emulator {

using namespace catalog;

namespace {

// Coils of §5.2.5 as bits of their register.
enum StateBit : quint16 {
    AlarmBit = 1 << 0,
    IndeterminateBit = 1 << 1,
    JudgmentHighBit = 1 << 2,
    JudgmentGoBit = 1 << 3,
    JudgmentLowBit = 1 << 4,
    TimerOffHighBit = 1 << 5,
    TimerOffGoBit = 1 << 6,
    TimerOffLowBit = 1 << 7,
    HoldBit = 1 << 8,
    ZeroBit = 1 << 9,
    LaserBit = 1 << 10,
    ErrorBit = 1 << 11,
    CautionBit = 1 << 12,
    NotificationBit = 1 << 13,
};
/// Bits of registers 400011–400014 that mean something.
constexpr std::array<quint16, 4> meaningfulBits{0x3fff, 0x000f, 0x0003, 0x0005};

quint16 flag(bool on, quint16 bit) { return on ? bit : 0; }

/// The digits of E100** as hexadecimal, without the E and the internal information (§8.2).
Value registerOf(ErrorState error)
{
    return (error.code / 100) << 8 | (error.code / 10 % 10) << 4 | error.code % 10;
}

} // namespace

bool VirtualSensor::isOutsideDisplay() const
{
    const auto value = m_chain.value();
    const Nanometres limit = Nanometres(Catalog::hlG2().model(model()).displayLimit) * nanometresPerWireUnit;
    return value && std::abs(*value) > limit;
}

Value VirtualSensor::measuredValue() const
{
    if (m_chain.alarmShown())
        return sentinel::alarm;
    const auto value = m_chain.value();
    if (!value)
        return sentinel::indeterminate;
    if (isOutsideDisplay())
        return *value > 0 ? sentinel::over : sentinel::under;
    return Value(*value / nanometresPerWireUnit); // §5.2.4: digits from 0.01 µm on are rounded down
}

Measured VirtualSensor::measured() const
{
    Measured measured;
    measured.value = m_chain.value();
    measured.indeterminate = !measured.value && !m_chain.alarmShown();
    measured.alarm = m_chain.alarm();
    measured.alarmShown = m_chain.alarmShown();
    measured.alarmNow = m_chain.alarmNow();
    measured.holding = m_chain.holding();
    measured.zeroSet = m_memory.value(ItemId::ZeroSetting) != 0;
    measured.laserEmitting = laserEmitting();
    measured.judgment = m_chain.judgment();
    measured.outputs = m_chain.outputs();
    if (measured.value)
        measured.peakIntensity = m_chain.reflection().peakIntensity;
    return measured;
}

Value VirtualSensor::read(ItemId id) const
{
    const SettingItem& item = hlG2(id);
    if (!item.isReadable())
        return 0;
    switch (id) {
    case ItemId::SensorState:
        return stateWord(0);
    case ItemId::SelfMonitoringNotification:
        return stateWord(1);
    case ItemId::SelfMonitoringCaution:
        return stateWord(2);
    case ItemId::SelfMonitoringError:
        return stateWord(3);
    case ItemId::ErrorCode:
        return registerOf(m_monitor.error());
    case ItemId::MeasuredValue:
        return measuredValue();
    case ItemId::PeakIntensity:
        return measured().peakIntensity.value_or(sentinel::noIntensity);
    case ItemId::TriggerInputExternal:
        return m_triggerLine.taken();
    case ItemId::TriggerInputCommunication:
        return m_triggerByCommunication;
    case ItemId::HoldState:
        return m_chain.holding();
    case ItemId::TeachingExecutionState:
        return Value(m_teaching.state());
    case ItemId::BrightnessTuningExecutionState:
        return Value(m_tuning.state());
    default:
        return m_memory.value(id);
    }
}

bool VirtualSensor::isOutsideRange() const
{
    const Value range = Catalog::hlG2().model(model()).measurementRange;
    return isMeasuring() && m_chain.measurable() &&
           std::abs(m_chain.reflection().distance) > range * nanometresPerWireUnit;
}

quint16 VirtualSensor::notification() const
{
    return SelfMonitoring::notificationBits(m_chain.reflection().light, m_chain.alarmNow(), isOutsideRange());
}

quint16 VirtualSensor::sensorState() const
{
    const Measured now = measured();
    const bool caution = m_monitor.cautionBits() != 0;
    const bool error = m_monitor.errorBits() != 0;
    return flag(now.alarm, AlarmBit) | flag(now.indeterminate, IndeterminateBit) |
           flag(now.outputs.high, JudgmentHighBit) | flag(now.outputs.go, JudgmentGoBit) |
           flag(now.outputs.low, JudgmentLowBit) | flag(now.judgment == Judgment::High, TimerOffHighBit) |
           flag(now.judgment == Judgment::Go, TimerOffGoBit) |
           flag(now.judgment == Judgment::Low, TimerOffLowBit) | flag(now.holding, HoldBit) |
           flag(now.zeroSet, ZeroBit) | flag(now.laserEmitting, LaserBit) | flag(error, ErrorBit) |
           flag(!error && caution, CautionBit) |
           flag(notification() != 0 || caution || error, NotificationBit);
}

quint16 VirtualSensor::stateWord(int index) const
{
    const std::array<quint16, 4> words{sensorState(), notification(), m_monitor.cautionBits(),
                                       m_monitor.errorBits()};
    const quint16 mask = meaningfulBits.at(std::size_t(index));
    const quint16 word = words.at(std::size_t(index)) & mask;
    return m_reservedOnes ? quint16(word | ~mask) : word;
}

bool VirtualSensor::coil(int number) const
{
    if (number < 1 || number > 64)
        return false;
    return (stateWord((number - 1) / 16) >> ((number - 1) % 16)) & 1;
}

int VirtualSensor::totalWriteCount() const
{
    return std::accumulate(m_writeCounts.begin(), m_writeCounts.end(), 0);
}

} // namespace lds::emulator

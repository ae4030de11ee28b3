#include "virtual_sensor.h"

#include <algorithm>
#include <numeric>

namespace lds::emulator {

using namespace catalog;

namespace {

/// Samples made up for after a long time without being asked; four times the longest average.
constexpr qint64 longestCatchUp = 4096;

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
enum NotificationDetail : quint16 {
    ExcessiveLightBit = 1 << 0,
    InsufficientLightBit = 1 << 1,
    OutsideRangeBit = 1 << 2,
    ExtraneousLightBit = 1 << 3,
};
/// Bits of registers 400011–400014 that mean something.
constexpr std::array<quint16, 4> meaningfulBits{0x3fff, 0x000f, 0x0003, 0x0005};

/// What a choice's code stands for. A code that no message could have written counts as the nearest.
template <typename T, std::size_t count>
T meaning(const std::array<T, count>& meanings, Value code)
{
    return meanings[std::size_t(std::clamp<Value>(code, 0, Value(count) - 1))];
}

quint16 flag(bool on, quint16 bit) { return on ? bit : 0; }

const ModelDescription& description(SensorModel model) { return Catalog::hlG2().model(model); }

} // namespace

VirtualSensor::VirtualSensor(const SettingsMemory& saved, EmulatorClock& clock, QObject* parent)
    : QObject(parent)
    , m_clock(clock)
    , m_memory(saved)
    , m_saved(saved)
    , m_workpiece(description(saved.model()))
    , m_sampledNs(clock.nowNs())
{
    activateCommunication();
    applySettings();
    if (laserEmitting())
        m_chain.settle(lookAt(m_sampledNs), false);
}

VirtualSensor::VirtualSensor(SensorModel model, EmulatorClock& clock, QObject* parent)
    : VirtualSensor(SettingsMemory(model), clock, parent)
{}

int VirtualSensor::silentForMs() const
{
    const qint64 left = m_silentUntilNs - m_clock.nowNs();
    return left > 0 ? int((left + 999'999) / 1'000'000) : 0;
}

void VirtualSensor::catchUp()
{
    const qint64 period = samplingNs();
    const qint64 due = (m_clock.nowNs() - m_sampledNs) / period;
    if (due > longestCatchUp)
        m_sampledNs += (due - longestCatchUp) * period;
    for (qint64 i = 0; i < std::min(due, longestCatchUp); ++i)
        takeSample(m_sampledNs + period);
}

void VirtualSensor::takeSample(qint64 timeNs)
{
    m_sampledNs = timeNs;
    m_chain.sample(lookAt(timeNs), laserEmitting(), triggerOn());
}

Reflection VirtualSensor::lookAt(qint64 timeNs) const
{
    Reflection reflection = m_workpiece.at(timeNs);
    if (m_placed)
        reflection.distance = *m_placed;
    reflection.light = m_light;
    if (m_light == Light::Insufficient)
        reflection.peakIntensity = 0;
    else if (m_light != Light::Measurable)
        reflection.peakIntensity = 1023;
    return reflection;
}

bool VirtualSensor::laserEmitting() const { return m_memory.value(ItemId::LaserStop) == 0; }

qint64 VirtualSensor::samplingNs() const
{
    static constexpr std::array<qint64, 5> cycles{100'000, 200'000, 500'000, 1'000'000, 2'000'000}; // §4.3.1
    return meaning(cycles, m_memory.value(ItemId::SamplingFrequency));
}

void VirtualSensor::applySettings()
{
    static constexpr std::array<int, 7> averages{1, 4, 16, 64, 256, 512, 1024}; // §4.3.2
    const auto length = [this](ItemId id) { return m_memory.value(id) * nanometresPerWireUnit; };
    ChainSettings settings;
    settings.averageTimes = meaning(averages, m_memory.value(ItemId::AverageTimes));
    settings.inverted = m_memory.value(ItemId::InversionOfMeasuredValue) != 0;
    if (m_memory.value(ItemId::ZeroSetting) != 0)
        settings.zeroCorrection = m_memory.zeroCorrection(m_memory.bank());
    settings.span = m_memory.value(ItemId::Span);
    settings.offset = length(ItemId::Offset);
    settings.high = length(ItemId::HighSetValue);
    settings.low = length(ItemId::LowSetValue);
    settings.hysteresis = length(ItemId::Hysteresis);
    settings.holdMode = HoldMode(m_memory.value(ItemId::HoldMode));
    settings.triggerMode = TriggerMode(m_memory.value(ItemId::TriggerMode));
    settings.alarmDelayCount = m_memory.value(ItemId::AlarmDelayCount);
    settings.alarmShown = m_memory.value(ItemId::AlarmDigitalOutput) != 0;
    m_chain.setSettings(settings);
}

Value VirtualSensor::measuredValue() const
{
    if (m_chain.alarmShown())
        return sentinel::alarm;
    const auto value = m_chain.value();
    if (!value)
        return sentinel::indeterminate;
    const Nanometres limit = Nanometres(description(model()).displayLimit) * nanometresPerWireUnit;
    if (*value > limit)
        return sentinel::over;
    if (*value < -limit)
        return sentinel::under;
    return Value(*value / nanometresPerWireUnit); // §5.2.4: digits from 0.01 µm on are rounded down
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
        return m_errorCode;
    case ItemId::MeasuredValue:
        return measuredValue();
    case ItemId::PeakIntensity:
        return m_chain.value() ? m_chain.reflection().peakIntensity : sentinel::noIntensity;
    case ItemId::TriggerInputExternal:
        return m_externalTrigger;
    case ItemId::TriggerInputCommunication:
        return m_triggerByCommunication;
    case ItemId::HoldState:
        return m_chain.holding();
    case ItemId::TeachingExecutionState:
    case ItemId::BrightnessTuningExecutionState:
        return 0; // not executed: this version cannot start them
    default:
        return m_memory.value(id);
    }
}

quint16 VirtualSensor::notification() const
{
    const Value range = description(model()).measurementRange;
    const Nanometres raw = m_chain.reflection().distance;
    const bool outside =
        laserEmitting() && m_chain.measurable() && std::abs(raw) > range * nanometresPerWireUnit;
    const bool alarm = m_chain.alarm();
    return flag(alarm && m_light == Light::Excessive, ExcessiveLightBit) |
           flag(alarm && m_light == Light::Insufficient, InsufficientLightBit) |
           flag(alarm && m_light == Light::ExtraneousLight, ExtraneousLightBit) |
           flag(outside, OutsideRangeBit);
}

quint16 VirtualSensor::sensorState() const
{
    const Judgment judgment = m_chain.judgment();
    const bool indeterminate = !m_chain.value() && !m_chain.alarmShown();
    const bool anything = notification() || m_cautionBits || m_errorBits;
    return flag(m_chain.alarm(), AlarmBit) | flag(indeterminate, IndeterminateBit) |
           flag(judgment == Judgment::High, JudgmentHighBit | TimerOffHighBit) |
           flag(judgment == Judgment::Go, JudgmentGoBit | TimerOffGoBit) |
           flag(judgment == Judgment::Low, JudgmentLowBit | TimerOffLowBit) |
           flag(m_chain.holding(), HoldBit) | flag(m_memory.value(ItemId::ZeroSetting) != 0, ZeroBit) |
           flag(laserEmitting(), LaserBit) | flag(m_errorBits != 0, ErrorBit) |
           flag(m_errorBits == 0 && m_cautionBits != 0, CautionBit) | flag(anything, NotificationBit);
}

quint16 VirtualSensor::stateWord(int index) const
{
    const std::array<quint16, 4> words{sensorState(), notification(), m_cautionBits, m_errorBits};
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

void VirtualSensor::setWriteFailure(ItemId id, bool fails)
{
    if (fails)
        m_failing.insert(id);
    else
        m_failing.remove(id);
}

void VirtualSensor::placeWorkpiece(Value rawValue)
{
    catchUp();
    m_placed = rawValue * nanometresPerWireUnit;
    if (laserEmitting() && m_light == Light::Measurable)
        m_chain.settle(lookAt(m_sampledNs), triggerOn());
}

void VirtualSensor::letWorkpieceMove()
{
    catchUp();
    m_placed.reset();
}

void VirtualSensor::setLight(Light light)
{
    catchUp();
    m_light = light;
}

void VirtualSensor::setExternalTrigger(bool on)
{
    catchUp();
    m_externalTrigger = on;
    takeSample(m_clock.nowNs());
}

void VirtualSensor::setCautionBits(quint16 bits) { m_cautionBits = bits & meaningfulBits[2]; }

void VirtualSensor::setErrorBits(quint16 bits) { m_errorBits = bits & meaningfulBits[3]; }

} // namespace lds::emulator

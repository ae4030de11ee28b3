// How a virtual sensor lives in time; what it answers, what writing does to it and its procedures stand in
// virtual_sensor_state.cpp, virtual_sensor_writes.cpp and virtual_sensor_procedures.cpp.
#include "virtual_sensor.h"

#include "workpiece.h"

#include <algorithm>
#include <array>

namespace lds::emulator {

using namespace catalog;

namespace {

/// Samples made up for after a long time without being asked: ten seconds of the shortest cycle.
constexpr qint64 longestCatchUp = 100'000;
constexpr int tickMs = 50;
constexpr qint64 secondNs = 1'000'000'000;
/// Where a workpiece stands that is outside the measurement range, in halves of that range.
constexpr Nanometres outOfRangeHalves = 3;
constexpr quint16 beamEmittingCircuitError = 200; ///< §8.2
constexpr quint16 cpuError = 120;

/// What a choice's code stands for. A code that no message could have written counts as the nearest.
template <typename T, std::size_t count>
T meaning(const std::array<T, count>& meanings, Value code)
{
    return meanings[std::size_t(std::clamp<Value>(code, 0, Value(count) - 1))];
}

std::optional<quint16> errorOf(SensorFault fault)
{
    if (fault == SensorFault::LaserCircuitError)
        return beamEmittingCircuitError;
    if (fault == SensorFault::SystemError)
        return cpuError;
    return std::nullopt;
}

} // namespace

VirtualSensor::VirtualSensor(const SettingsMemory& saved, EmulatorClock& clock, QObject* parent)
    : QObject(parent)
    , m_clock(clock)
    , m_memory(saved)
    , m_saved(saved)
    , m_gentleWorkpiece(std::make_shared<Workpiece>(Catalog::hlG2().model(saved.model())))
    , m_scenery(m_gentleWorkpiece)
    , m_sampledNs(clock.nowNs())
    , m_lifeFollowedNs(clock.nowNs())
{
    activateCommunication();
    applySettings();
    m_receiver.settle(sightAt(m_sampledNs), m_cycleNs);
    if (isMeasuring())
        m_chain.settle(lookAt(m_sampledNs), false, m_sampledNs);
    startTick();
}

VirtualSensor::VirtualSensor(SensorModel model, EmulatorClock& clock, QObject* parent)
    : VirtualSensor(SettingsMemory(model), clock, parent)
{}

/// Samples are taken as they fall due though nobody asks: peaks are not missed, faults and tuning go on.
void VirtualSensor::startTick()
{
    m_clock.after(tickMs, this, [this] {
        catchUp();
        startTick();
    });
}

int VirtualSensor::silentForMs() const
{
    const qint64 left = m_silentUntilNs - m_clock.nowNs();
    return left > 0 ? int((left + 999'999) / 1'000'000) : 0;
}

void VirtualSensor::beSilentForMs(int milliseconds)
{
    m_silentUntilNs = std::max(m_silentUntilNs, m_clock.nowNs() + milliseconds * 1'000'000LL);
}

void VirtualSensor::catchUp()
{
    const qint64 now = m_clock.nowNs();
    qint64 due = (now - m_sampledNs) / m_cycleNs;
    if (due > longestCatchUp) {
        m_sampledNs += (due - longestCatchUp) * m_cycleNs;
        due = longestCatchUp;
    }
    for (; due > 0; --due)
        takeSample(m_sampledNs + m_cycleNs);
    m_triggerLine.at(now);
    m_chain.advance(now);
    followLife();
}

void VirtualSensor::takeSample(qint64 timeNs)
{
    m_sampledNs = timeNs;
    m_triggerLine.at(timeNs);
    m_chain.sample(lookAt(timeNs), isMeasuring(), triggerOn(), timeNs);
    if (m_tuning.isAdjusting())
        sampleTuning(timeNs);
}

/// Between samples, after something has changed.
void VirtualSensor::refresh()
{
    applySettings();
    m_chain.refresh(isMeasuring(), triggerOn(), m_clock.nowNs());
}

Sight VirtualSensor::sightAt(qint64 timeNs) const
{
    Sight sight = m_scenery->at(timeNs - m_sceneryBeganNs);
    if (m_placed) {
        sight.present = true;
        sight.distance = *m_placed;
    }
    if (hasFault(SensorFault::OutOfRange)) {
        const Value range = Catalog::hlG2().model(model()).measurementRange;
        sight.present = true;
        sight.distance = range * nanometresPerWireUnit * outOfRangeHalves / 2;
    }
    return sight;
}

Reflection VirtualSensor::lookAt(qint64 timeNs)
{
    Reflection reflection = m_receiver.receive(sightAt(timeNs), m_cycleNs);
    Light spoiled = m_light;
    if (!m_faults.isEmpty()) {
        if (hasFault(SensorFault::NoLight))
            spoiled = Light::Insufficient;
        else if (hasFault(SensorFault::Saturated))
            spoiled = Light::Excessive;
        else if (hasFault(SensorFault::AmbientLight))
            spoiled = Light::ExtraneousLight;
    }
    if (spoiled != Light::Measurable) {
        reflection.light = spoiled;
        reflection.peakIntensity = spoiled == Light::Insufficient ? 0 : LightReceiver::mostIntensity;
    }
    return reflection;
}

bool VirtualSensor::laserEmitting() const
{
    return !m_laserStopped && !m_monitor.has(beamEmittingCircuitError);
}

void VirtualSensor::applySettings()
{
    static constexpr std::array<qint64, 5> cycles{100'000, 200'000, 500'000, 1'000'000, 2'000'000}; // §4.3.1
    static constexpr std::array<int, 7> averages{1, 4, 16, 64, 256, 512, 1024};                     // §4.3.2
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
    settings.outputDelay = {OutputDelay(m_memory.value(ItemId::OutputDelayTimerSelection)),
                            m_memory.value(ItemId::OutputDelayTimerSetting) * 1'000'000LL};
    m_chain.setSettings(settings);
    m_cycleNs = meaning(cycles, m_memory.value(ItemId::SamplingFrequency));
    m_laserStopped = m_memory.value(ItemId::LaserStop) != 0;
    const bool isTuned = m_memory.value(ItemId::BrightnessTuning) != 0 && !m_tuning.isExecuting();
    m_receiver.setRange(isTuned ? m_memory.tunedBrightness(m_memory.bank()) : std::nullopt);
}

void VirtualSensor::restartMeasurement()
{
    applySettings();
    m_chain.restart();
}

/// §4.13: operating hours are counted while it lives, and kept each full hour.
void VirtualSensor::followLife()
{
    const qint64 seconds = (m_clock.nowNs() - m_lifeFollowedNs) / secondNs;
    if (seconds <= 0)
        return;
    constexpr qint64 hour = 3600;
    const qint64 before = m_monitor.life.operatingSeconds;
    m_lifeFollowedNs += seconds * secondNs;
    m_monitor.life.operatingSeconds += seconds;
    if (m_store && before / hour != m_monitor.life.operatingSeconds / hour) {
        if (const auto stored = m_store(m_saved, m_monitor.life); !stored)
            Q_EMIT storeFailed(stored.error());
    }
}

void VirtualSensor::activateCommunication()
{
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (item.effect == Effect::AfterCommunicationReset && SettingsMemory::holds(item))
            m_active.insert(item.id, m_memory.value(item.id));
    }
}

void VirtualSensor::powerCycle()
{
    catchUp();
    m_memory = m_saved;
    m_inMenu = false;
    m_triggerByCommunication = false;
    m_silentUntilNs = 0;
    m_teaching.interrupt();
    m_tuning.interrupt();
    m_monitor.clearByPowerCycle();
    for (const SensorFault fault : std::as_const(m_faults)) { // what still goes wrong goes wrong again
        if (const auto code = errorOf(fault))
            m_monitor.raise({*code, 0});
    }
    activateCommunication();
    restartMeasurement();
    m_chain.reset();
    m_sampledNs = m_clock.nowNs();
    refresh();
    Q_EMIT poweredOn();
}

void VirtualSensor::setScenery(std::shared_ptr<const Scenery> scenery)
{
    catchUp();
    m_scenery = scenery ? std::move(scenery) : m_gentleWorkpiece;
    m_sceneryBeganNs = m_clock.nowNs();
    m_placed.reset();
}

void VirtualSensor::setFault(SensorFault fault, bool on)
{
    catchUp();
    if (on)
        m_faults.insert(fault);
    else
        m_faults.remove(fault);
    if (const auto code = errorOf(fault)) {
        if (on)
            m_monitor.raise({*code, 0});
        else
            m_monitor.clear(*code);
        refresh();
    }
}

void VirtualSensor::raiseError(ErrorState error)
{
    catchUp();
    m_monitor.raise(error);
    refresh();
}

void VirtualSensor::setLife(const LifeCounters& life)
{
    catchUp();
    m_monitor.life = life;
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
    if (isMeasuring() && m_light == Light::Measurable)
        m_chain.settle(lookAt(m_sampledNs), triggerOn(), m_clock.nowNs());
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
    m_triggerLine.set(on, m_clock.nowNs());
}

} // namespace lds::emulator

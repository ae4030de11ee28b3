#include "scene_player.h"

#include <algorithm>
#include <limits>

namespace lds::emulator {

namespace {

constexpr qint64 nanosecondsPerMillisecond = 1'000'000;
/// Edges made up for one by one after a stall; further back, only what is so now counts.
constexpr int mostEdgesAtOnce = 10'000;

qint64 inMilliseconds(qint64 nanoseconds) { return nanoseconds / nanosecondsPerMillisecond; }

} // namespace

std::optional<qint64> nextEdgeMs(const Interval& interval, qint64 afterMs)
{
    if (afterMs < interval.atMs)
        return interval.atMs;
    if (interval.forMs <= 0)
        return std::nullopt;
    const qint64 since = afterMs - interval.atMs;
    if (interval.everyMs <= 0)
        return since < interval.forMs ? std::optional(interval.atMs + interval.forMs) : std::nullopt;
    const qint64 phase = since % interval.everyMs;
    const qint64 cycle = afterMs - phase;
    return phase < interval.forMs ? cycle + interval.forMs : cycle + interval.everyMs;
}

ScenePlayer::ScenePlayer(VirtualSensor& sensor, FaultDesk& faults, EmulatorClock& clock,
                         ReplayClock& sensorClock)
    : m_sensor(sensor)
    , m_faults(faults)
    , m_clock(clock)
    , m_sensorClock(sensorClock)
{}

void ScenePlayer::play(std::shared_ptr<const Scene> scene)
{
    standStill();
    m_scene = std::move(scene);
    start();
    Q_EMIT changed();
}

void ScenePlayer::letMove()
{
    if (isMoving())
        return;
    start();
    Q_EMIT changed();
}

void ScenePlayer::start()
{
    m_held.clear();
    m_heldAt.reset();
    m_sensor.setScenery(m_scene);
    m_beganNs = m_sensorClock.nowNs();
    m_doneMs = 0;
    takeUp(0);
    waitForNextEdge();
}

bool ScenePlayer::holdStill(const QString& workpiece)
{
    const auto scenery = m_scene ? m_scene->holdingStill(workpiece) : nullptr;
    if (!scenery)
        return false;
    standStill();
    m_held = workpiece;
    m_heldAt.reset();
    m_sensor.setScenery(scenery);
    Q_EMIT changed();
    return true;
}

void ScenePlayer::holdAt(catalog::Value rawValue)
{
    standStill();
    m_held.clear();
    m_heldAt = rawValue;
    m_sensor.setScenery(nullptr); // nothing of the scene's light is left
    m_sensor.placeWorkpiece(rawValue);
    Q_EMIT changed();
}

void ScenePlayer::standStill()
{
    follow();
    m_clock.cancel(m_timer);
    m_timer = 0;
    m_faults.switchAllOff(FaultDesk::By::Scene);
    m_scheduled.clear();
    setTriggers(m_triggerByPerson, false);
}

void ScenePlayer::setTrigger(bool on)
{
    follow();
    if (on == m_triggerByPerson)
        return;
    setTriggers(on, m_triggerByScene);
    Q_EMIT changed();
}

void ScenePlayer::setTriggers(bool person, bool scene)
{
    const bool before = m_triggerByPerson || m_triggerByScene;
    m_triggerByPerson = person;
    m_triggerByScene = scene;
    if (before != (person || scene))
        m_sensor.setExternalTrigger(person || scene);
}

void ScenePlayer::follow()
{
    if (!m_scene || !isMoving())
        return;
    const qint64 nowMs = inMilliseconds(m_clock.nowNs() - m_beganNs);
    int edges = 0;
    for (auto due = nextEdgeMs(m_doneMs); due && *due <= nowMs; due = nextEdgeMs(m_doneMs)) {
        m_doneMs = ++edges < mostEdgesAtOnce ? *due : nowMs;
        m_sensorClock.standAt(m_beganNs + m_doneMs * nanosecondsPerMillisecond);
        takeUp(m_doneMs);
        m_sensorClock.goOn();
    }
    if (edges > 0) {
        waitForNextEdge();
        Q_EMIT changed();
    }
}

/// What the scene has on at this moment, from what it had on before.
void ScenePlayer::takeUp(qint64 timeMs)
{
    if (!m_scene)
        return;
    takeUpFaults(timeMs);
    const auto& triggers = m_scene->triggers();
    const bool trigger = std::any_of(triggers.begin(), triggers.end(),
                                     [timeMs](const Interval& interval) { return interval.covers(timeMs); });
    setTriggers(m_triggerByPerson, trigger);
}

void ScenePlayer::takeUpFaults(qint64 timeMs)
{
    std::map<NamedFault, int> on; // with the longest time
    for (const ScheduledFault& fault : m_scene->faults()) {
        if (fault.when.covers(timeMs))
            on[fault.fault] = std::max(on[fault.fault], fault.milliseconds);
    }
    for (const NamedFault fault : allFaults()) {
        const auto wanted = on.find(fault);
        const bool was = m_scheduled.contains(fault);
        if (wanted == on.end() && was)
            m_faults.switchOff(fault, FaultDesk::By::Scene);
        else if (wanted != on.end() && (!was || m_scheduled.at(fault) != wanted->second))
            m_faults.switchOn(fault, FaultDesk::By::Scene, wanted->second);
    }
    m_scheduled = std::move(on);
}

std::optional<qint64> ScenePlayer::nextEdgeMs(qint64 afterMs) const
{
    std::optional<qint64> next;
    const auto consider = [&next, afterMs](const Interval& interval) {
        const auto edge = emulator::nextEdgeMs(interval, afterMs);
        if (edge && (!next || *edge < *next))
            next = edge;
    };
    for (const ScheduledFault& fault : m_scene->faults())
        consider(fault.when);
    for (const Interval& trigger : m_scene->triggers())
        consider(trigger);
    return next;
}

void ScenePlayer::waitForNextEdge()
{
    m_clock.cancel(m_timer);
    m_timer = 0;
    const auto edge = m_scene ? nextEdgeMs(m_doneMs) : std::nullopt;
    if (!edge)
        return;
    const qint64 dueNs = m_beganNs + *edge * nanosecondsPerMillisecond;
    const qint64 delayMs = inMilliseconds(dueNs - m_clock.nowNs() + nanosecondsPerMillisecond - 1);
    m_timer =
        m_clock.after(int(std::clamp<qint64>(delayMs, 0, std::numeric_limits<int>::max())), this, [this] {
            m_timer = 0;
            follow();
            if (m_timer == 0)
                waitForNextEdge(); // woken a little early
        });
}

} // namespace lds::emulator

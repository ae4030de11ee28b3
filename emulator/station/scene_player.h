#pragma once

#include "fault_desk.h"
#include "replay_clock.h"
#include "scene.h"

#include <map>
#include <memory>
#include <optional>
#include <QObject>

namespace lds::emulator {

/// Puts what there is to see before a virtual sensor, and follows a scene's faults and trigger input at
/// their times, each edge at its moment however late the event loop comes.
///
/// While a workpiece is held still the scene stands still too: none of its faults and triggers happen.
/// When it moves again, the scene starts from its beginning.
class ScenePlayer final : public QObject {
    Q_OBJECT

public:
    /// `sensorClock` is the one the sensor has.
    ScenePlayer(VirtualSensor& sensor, FaultDesk& faults, EmulatorClock& clock, ReplayClock& sensorClock);

    /// Plays it from its beginning; nothing = a workpiece that moves gently inside the range.
    void play(std::shared_ptr<const Scene> scene);
    const std::shared_ptr<const Scene>& scene() const { return m_scene; }
    /// False, and nothing changes, when the scene has no workpiece of this name.
    bool holdStill(const QString& workpiece);
    /// Holds something bright still, `rawValue` (0.1 µm, before inversion and zero) from the centre.
    void holdAt(catalog::Value rawValue);
    void letMove();
    bool isMoving() const { return m_held.isEmpty() && !m_heldAt; }
    QString held() const { return m_held; } ///< The workpiece held still; empty when none is.
    std::optional<catalog::Value> heldAt() const { return m_heldAt; }

    /// A person's hand on the trigger input line; the scene's own trigger is ORed.
    void setTrigger(bool on);
    bool triggerByPerson() const { return m_triggerByPerson; }
    bool triggerByScene() const { return m_triggerByScene; }

    /// Does what has fallen due: before the sensor is asked something, so that no edge comes too late.
    void follow();

Q_SIGNALS:
    void changed();

private:
    void start();
    void standStill();
    void takeUp(qint64 timeMs);
    void takeUpFaults(qint64 timeMs);
    void setTriggers(bool person, bool scene);
    std::optional<qint64> nextEdgeMs(qint64 afterMs) const;
    void waitForNextEdge();

    VirtualSensor& m_sensor;
    FaultDesk& m_faults;
    EmulatorClock& m_clock;
    ReplayClock& m_sensorClock; ///< Not asked for the time before edges are made up for.
    std::shared_ptr<const Scene> m_scene;
    QString m_held;
    std::optional<catalog::Value> m_heldAt;
    bool m_triggerByPerson = false;
    bool m_triggerByScene = false;
    std::map<NamedFault, int> m_scheduled; ///< Faults the scene has on, with their milliseconds.
    qint64 m_beganNs = 0;
    qint64 m_doneMs = 0; ///< Edges up to here have been taken up.
    EmulatorClock::TimerId m_timer = 0;
};

/// When an interval begins or ends next, later than `afterMs`; nothing when it never does again.
std::optional<qint64> nextEdgeMs(const Interval& interval, qint64 afterMs);

} // namespace lds::emulator

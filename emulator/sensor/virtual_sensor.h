#pragma once

#include "brightness_tuning.h"
#include "emulator_clock.h"
#include "light_receiver.h"
#include "measurement_chain.h"
#include "scenery.h"
#include "self_monitoring.h"
#include "settings_memory.h"
#include "teaching.h"
#include "trigger_line.h"
#include "write_judge.h"

#include <functional>
#include <memory>
#include <optional>
#include <QMap>
#include <QObject>
#include <QSet>
#include <tl/expected.hpp>

namespace lds::emulator {

/// Why the sensor does not carry a message out; each protocol has its own code for it.
enum class Refusal : quint8 {
    NotReady, ///< In its menu (§5.2.2, code 04).
    Data,     ///< A value out of range, inconsistent or reserved; nothing was written (code 03).
    Failed,   ///< The write of one item failed; what was written before it stays (code 04).
};

struct WriteOutcome {
    int written = 0; ///< Items.
    std::optional<Refusal> refusal;
    QString reason; ///< For logs; empty when all went well.
};

/// What goes wrong with the sensor itself on purpose; several at a time.
enum class SensorFault : quint8 {
    NoLight,           ///< Insufficient intensity of received light (§4.7).
    Saturated,         ///< Excessive intensity of received light (§4.7).
    AmbientLight,      ///< Excessive extraneous light (§4.7).
    OutOfRange,        ///< The raw value outside the measurement range (§4.13).
    LaserCircuitError, ///< E200 (§8.2)
    SystemError,       ///< E120 (§8.2)
    InMenu,            ///< Somebody is in the setting mode: not ready (§5.2.2).
};

/// What the sensor measures and shows at one moment.
struct Measured {
    std::optional<Nanometres> value; ///< The final measured value; nothing while indeterminate.
    bool indeterminate = true;
    bool alarm = false;      ///< As coil 1.
    bool alarmShown = false; ///< The alarm stands in place of the value (§4.7.2).
    bool alarmNow = false;   ///< The alarm indicator: whatever is held.
    bool holding = false;
    bool zeroSet = false;
    bool laserEmitting = false;
    Judgment judgment = Judgment::None; ///< At timer OFF.
    JudgmentOutputs outputs;
    std::optional<int> peakIntensity; ///< 0 … 1023; nothing while indeterminate.
};

/// A virtual HL-G2: the items, what they do to each other, and a measured value that lives. It knows no
/// protocol; servers ask it item by item. It lives in one thread and follows the clock it is given,
/// whenever it is asked something and a few times a second by itself, so that no sample is left out.
class VirtualSensor : public QObject {
    Q_OBJECT

public:
    /// Writes what is to survive power-off; an error makes the saving fail as in a worn-out memory.
    using Store = std::function<tl::expected<void, QString>(const SettingsMemory&, const LifeCounters&)>;

    /// Starts with `saved` as its saved memory. Running since long: the value is there at once.
    VirtualSensor(const SettingsMemory& saved, EmulatorClock& clock, QObject* parent = nullptr);
    /// Starts with factory defaults.
    VirtualSensor(catalog::SensorModel model, EmulatorClock& clock, QObject* parent = nullptr);

    catalog::SensorModel model() const { return m_memory.model(); }
    void setStore(Store store) { m_store = std::move(store); }

    // What a server asks.
    bool isReady() const { return !m_inMenu && !hasFault(SensorFault::InMenu); }
    /// Milliseconds for which the sensor stays silent because it is saving (§5.3.3).
    int silentForMs() const;
    /// Follows the clock: everything read until the next call belongs to one moment.
    void catchUp();
    /// Of an item that can be read; 0 for others.
    catalog::Value read(catalog::ItemId id) const;
    /// Coils 1–16 in the first word, and so on, as registers 400011–400014 show them (§5.2.5).
    quint16 stateWord(int index) const;
    bool coil(int number) const; ///< 1 … 64
    /// One message: judged as a whole (§5.2.3), then carried out in order.
    WriteOutcome write(const QList<ItemWrite>& writes);

    // What the front panel asks.
    /// Judged as a message is, but saved at once, and possible while isReady() is false.
    WriteOutcome writeByKeys(const QList<ItemWrite>& writes);
    /// Teaching (§4.9) in the mode that is set; refused as Failed while it cannot be started.
    WriteOutcome startTeaching(Operator by);
    WriteOutcome takeTeachingPoint(int point); ///< 1 … 3, in their order.
    WriteOutcome interruptTeaching();
    const Teaching& teaching() const { return m_teaching; }
    /// Brightness tuning (§4.3.3).
    WriteOutcome startTuning(Operator by);
    WriteOutcome takeTuningPoint(int point); ///< 1 or 2, in their order.
    WriteOutcome interruptTuning();          ///< The brightness is what it was before.
    const BrightnessTuning& tuning() const { return m_tuning; }
    /// §4.3.3, §4.9: the keys cannot change screens meanwhile.
    bool procedureByCommunication() const;
    Measured measured() const; ///< As of the last catchUp().
    ErrorState error() const { return m_monitor.error(); }
    void setInputPolarity(InputPolarity polarity); ///< At the keys (§3.6); saved.

    // What tests ask.
    const SettingsMemory& memory() const { return m_memory; }     ///< Works with.
    const SettingsMemory& savedMemory() const { return m_saved; } ///< Would have after a power cycle.
    int writeCount(catalog::ItemId id) const { return m_writeCounts.value(id); } ///< Carried out or failed.
    int totalWriteCount() const;
    int memoryWriteCount() const { return m_memoryWrites; } ///< Writes to non-volatile memory.
    /// The communication setting that counts now: as of the last communication reset or power cycle.
    catalog::Value activeValue(catalog::ItemId id) const { return m_active.value(id); }

    // What happens to it, beside messages.
    void powerCycle();
    /// "Set value initialization" (§4.8.6): ENTER held while the power comes on.
    void initializeSetValues();
    /// What it looks at from now on, its time beginning now; nothing: a workpiece that moves gently.
    void setScenery(std::shared_ptr<const Scenery> scenery);
    void setFault(SensorFault fault, bool on);
    bool hasFault(SensorFault fault) const { return m_faults.contains(fault); }
    void raiseError(ErrorState error); ///< §8.2; until the action that helps against it.
    /// Silent as while it writes to its memory (§5.3.3).
    void beSilentForMs(int milliseconds);
    void setLife(const LifeCounters& life);
    LifeCounters life() const { return m_monitor.life; }
    /// In its menu by the keys; the fault InMenu counts beside it.
    void setInMenu(bool inMenu) { m_inMenu = inMenu; }
    /// Someone changes an item at the keys: at once, saved, judged by nobody.
    void changeByKeypad(catalog::ItemId id, catalog::Value value);
    /// Writes to this item fail from now on ("this product failed to write data").
    void setWriteFailure(catalog::ItemId id, bool fails);
    /// Holds a workpiece still, `rawValue` (0.1 µm, before inversion and zero) from the centre, as if it
    /// had stood there since long.
    void placeWorkpiece(catalog::Value rawValue);
    void letWorkpieceMove();    ///< The moving one again.
    void setLight(Light light); ///< Anything but Measurable raises an alarm after the delay (§4.7.1).
    /// The trigger input line; what is shorter than 2 ms is not seen (§4.6.2).
    void setExternalTrigger(bool on);
    /// Reserved bits "read as anything" (§5.2.5): as ones, to see who fails to mask them.
    void setReservedBits(bool ones) { m_reservedOnes = ones; }
    void setSavingDuration(int milliseconds) { m_savingMs = milliseconds; }

Q_SIGNALS:
    /// An item was written by a message or at the keys.
    void written(lds::catalog::ItemId id, lds::catalog::Value value);
    void memoryWritten(); ///< The saved memory changed.
    /// Network and RS-485 settings take effect (§4.8.5). Comes before the answer to the message.
    void communicationReset();
    void poweredOn(); ///< After a power cycle: what was connected is not any more.
    void storeFailed(const QString& reason);

private:
    WriteOutcome carryOutAll(const QList<ItemWrite>& writes, Operator by);
    bool carryOut(const ItemWrite& write, Operator by);
    bool carryOutStored(const ItemWrite& write, Operator by);
    bool carryOutCommand(const ItemWrite& write, Operator by);
    bool writeBrightnessTuning(bool on, Operator by);
    bool setZero(bool on);
    bool copyBank(catalog::Value combination);
    bool saveMemory(const SettingsMemory& memory);
    /// Of the bank in use, with what stands beside the items in memory.
    bool saveItems(const QList<catalog::ItemId>& ids);
    bool isSavedAtOnce(catalog::ItemId id) const;
    bool initialize(catalog::Value what);
    void store(catalog::ItemId id, catalog::Value value, SettingsMemory& memory) const;

    bool canStartProcedure() const;
    void interruptProcedures();
    void finishTeaching(const TaughtWindow& window);
    void sampleTuning(qint64 timeNs);
    void finishTuning(const BrightnessRange& range);
    void abandonTuning();
    TeachingConditions teachingConditions() const;

    void startTick();
    void applySettings();
    void refresh();
    void restartMeasurement();
    void takeSample(qint64 timeNs);
    void followLife();
    void breakOff();
    void activateCommunication();
    bool triggerOn() const { return m_triggerLine.taken() || m_triggerByCommunication; }
    bool laserEmitting() const;
    bool isMeasuring() const { return laserEmitting() && m_monitor.error().code == 0; }
    Reflection lookAt(qint64 timeNs);
    Sight sightAt(qint64 timeNs) const;
    bool isOutsideRange() const;
    bool isOutsideDisplay() const;
    catalog::Value measuredValue() const;
    quint16 sensorState() const;
    quint16 notification() const;

    EmulatorClock& m_clock;
    SettingsMemory m_memory;
    SettingsMemory m_saved;
    QMap<catalog::ItemId, catalog::Value> m_active;
    Store m_store;
    MeasurementChain m_chain;
    LightReceiver m_receiver;
    TriggerLine m_triggerLine;
    Teaching m_teaching;
    BrightnessTuning m_tuning;
    catalog::Value m_brightnessBefore = 0; ///< Brightness tuning ON or OFF before the one that runs.
    SelfMonitoring m_monitor;
    std::shared_ptr<const Scenery> m_gentleWorkpiece;
    std::shared_ptr<const Scenery> m_scenery;
    qint64 m_sceneryBeganNs = 0;
    qint64 m_sampledNs = 0; ///< When the last sample was taken.
    qint64 m_cycleNs = 1'000'000;
    bool m_laserStopped = false;
    qint64 m_lifeFollowedNs = 0;

    QMap<catalog::ItemId, int> m_writeCounts;
    int m_memoryWrites = 0;
    QSet<catalog::ItemId> m_failing;
    QSet<SensorFault> m_faults;
    std::optional<Nanometres> m_placed;
    Light m_light = Light::Measurable;
    bool m_inMenu = false;
    bool m_triggerByCommunication = false;
    bool m_reservedOnes = false;
    int m_savingMs = 0;
    qint64 m_silentUntilNs = 0;
};

} // namespace lds::emulator

#pragma once

#include "emulator_clock.h"
#include "measurement_chain.h"
#include "settings_memory.h"
#include "write_judge.h"

#include <functional>
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

/// A virtual HL-G2: the items, what they do to each other, and a measured value that lives. It knows no
/// protocol; servers ask it item by item. It lives in one thread and follows the clock it is given,
/// whenever it is asked something.
///
/// Not in this version: teaching and tuning (starting them is refused as Failed, their states stay "not
/// executed"), the output delay timers (both sets of judgment bits are the same), and rebinding of
/// servers after a communication reset (communicationReset() tells who would have to).
class VirtualSensor : public QObject {
    Q_OBJECT

public:
    /// Writes what is to survive power-off; an error makes the saving fail as in a worn-out memory.
    using Store = std::function<tl::expected<void, QString>(const SettingsMemory&)>;

    /// Starts with `saved` as its saved memory. Running since long: the value is there at once.
    VirtualSensor(const SettingsMemory& saved, EmulatorClock& clock, QObject* parent = nullptr);
    /// Starts with factory defaults.
    VirtualSensor(catalog::SensorModel model, EmulatorClock& clock, QObject* parent = nullptr);

    catalog::SensorModel model() const { return m_memory.model(); }
    void setStore(Store store) { m_store = std::move(store); }

    // What a server asks.
    bool isReady() const { return !m_inMenu; }
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

    // What tests ask.
    const SettingsMemory& memory() const { return m_memory; }     ///< Works with.
    const SettingsMemory& savedMemory() const { return m_saved; } ///< Would have after a power cycle.
    int writeCount(catalog::ItemId id) const { return m_writeCounts.value(id); } ///< Carried out or failed.
    int totalWriteCount() const;
    int memoryWriteCount() const { return m_memoryWrites; } ///< Writes to non-volatile memory.
    /// The communication setting that counts now: as of the last communication reset or power cycle.
    catalog::Value activeValue(catalog::ItemId id) const { return m_active.value(id); }

    // What happens to it, beside messages: test hooks and later the panel.
    void powerCycle();
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
    void setExternalTrigger(bool on);
    void setCautionBits(quint16 bits);
    void setErrorBits(quint16 bits);
    void setErrorCode(quint16 code) { m_errorCode = code; }
    /// Reserved bits "read as anything" (§5.2.5): as ones, to see who fails to mask them.
    void setReservedBits(bool ones) { m_reservedOnes = ones; }
    void setSavingDuration(int milliseconds) { m_savingMs = milliseconds; }

Q_SIGNALS:
    /// An item was written by a message or at the keys.
    void written(lds::catalog::ItemId id, lds::catalog::Value value);
    void memoryWritten(); ///< The saved memory changed.
    /// Network and RS-485 settings take effect. On loopback nothing is bound anew.
    void communicationReset();
    void storeFailed(const QString& reason);

private:
    bool carryOut(const ItemWrite& write);
    bool carryOutStored(const ItemWrite& write);
    bool carryOutCommand(const ItemWrite& write);
    bool setZero(bool on);
    bool copyBank(catalog::Value combination);
    bool saveMemory(const SettingsMemory& memory);
    bool initialize(catalog::Value what);
    void store(catalog::ItemId id, catalog::Value value, SettingsMemory& memory) const;
    void applySettings();
    void restartMeasurement();
    void takeSample(qint64 timeNs);
    void breakOff();
    void activateCommunication();
    bool triggerOn() const { return m_externalTrigger || m_triggerByCommunication; }
    bool laserEmitting() const;
    Reflection lookAt(qint64 timeNs) const;
    qint64 samplingNs() const;
    catalog::Value measuredValue() const;
    quint16 sensorState() const;
    quint16 notification() const;

    EmulatorClock& m_clock;
    SettingsMemory m_memory;
    SettingsMemory m_saved;
    QMap<catalog::ItemId, catalog::Value> m_active;
    Store m_store;
    MeasurementChain m_chain;
    Workpiece m_workpiece;
    qint64 m_sampledNs = 0; ///< When the last sample was taken.

    QMap<catalog::ItemId, int> m_writeCounts;
    int m_memoryWrites = 0;
    QSet<catalog::ItemId> m_failing;
    std::optional<Nanometres> m_placed;
    Light m_light = Light::Measurable;
    bool m_inMenu = false;
    bool m_externalTrigger = false;
    bool m_triggerByCommunication = false;
    bool m_reservedOnes = false;
    quint16 m_cautionBits = 0;
    quint16 m_errorBits = 0;
    quint16 m_errorCode = 0;
    int m_savingMs = 0;
    qint64 m_silentUntilNs = 0;
};

} // namespace lds::emulator

// What writing to a virtual sensor does; what it measures and answers stands in virtual_sensor.cpp.
#include "virtual_sensor.h"

namespace lds::emulator {

using namespace catalog;

namespace {

struct BankCopy {
    int from;
    int to;
};

/// §4.2 "Bank copy", by set value.
constexpr std::array<BankCopy, 12> bankCopies{
    {{0, 1}, {0, 2}, {0, 3}, {1, 0}, {1, 2}, {1, 3}, {2, 0}, {2, 1}, {2, 3}, {3, 0}, {3, 1}, {3, 2}}};

// §4.8.6: 1 … 4 one bank, then these.
constexpr Value allBanks = 5;
constexpr Value allAreas = 6;

/// A change of these starts the measurement afresh: indeterminate until the average is full (§4.3.2,
/// §4.6.2; the others likewise change what is averaged or held).
bool restartsMeasurement(ItemId id)
{
    return id == ItemId::AverageTimes || id == ItemId::SamplingFrequency || id == ItemId::HoldMode ||
           id == ItemId::TriggerMode || id == ItemId::BankSwitching;
}

} // namespace

WriteOutcome VirtualSensor::write(const QList<ItemWrite>& writes)
{
    catchUp();
    if (!isReady())
        return {0, Refusal::NotReady, QStringLiteral("the sensor is in its menu")};
    return carryOutAll(writes, Operator::Communication);
}

WriteOutcome VirtualSensor::writeByKeys(const QList<ItemWrite>& writes)
{
    catchUp();
    return carryOutAll(writes, Operator::Keys);
}

WriteOutcome VirtualSensor::carryOutAll(const QList<ItemWrite>& writes, Operator by)
{
    const auto judged = judgeWrites(m_memory, writes);
    if (!judged) {
        const QString key = QString::fromLatin1(hlG2(judged.error().item).key);
        return {0, Refusal::Data, key + QStringLiteral(": ") + judged.error().reason};
    }
    WriteOutcome outcome;
    QList<ItemId> toSave;
    for (const ItemWrite& write : *judged) {
        if (by == Operator::Communication)
            ++m_writeCounts[write.item];
        if (m_failing.contains(write.item) || !carryOut(write, by)) {
            outcome.refusal = Refusal::Failed;
            outcome.reason = QString::fromLatin1(hlG2(write.item).key) + QStringLiteral(": writing failed");
            break;
        }
        ++outcome.written;
        if (by == Operator::Keys && isSavedAtOnce(write.item))
            toSave.append(write.item);
        Q_EMIT written(write.item, write.value);
    }
    if (!toSave.isEmpty() && !saveItems(toSave)) {
        outcome.refusal = Refusal::Failed;
        outcome.reason = QStringLiteral("saving failed");
    }
    return outcome;
}

/// Tuning that has just been started is saved at its end.
bool VirtualSensor::isSavedAtOnce(ItemId id) const
{
    return SettingsMemory::holds(hlG2(id)) && !(id == ItemId::BrightnessTuning && m_tuning.isExecuting());
}

bool VirtualSensor::carryOut(const ItemWrite& write, Operator by)
{
    return SettingsMemory::holds(hlG2(write.item)) ? carryOutStored(write, by) : carryOutCommand(write, by);
}

bool VirtualSensor::carryOutStored(const ItemWrite& write, Operator by)
{
    if (write.item == ItemId::BrightnessTuning)
        return writeBrightnessTuning(write.value != 0, by);
    if (write.item == ItemId::ZeroSetting)
        return setZero(write.value != 0);
    if (write.item == ItemId::BankSwitching)
        interruptProcedures(); // before the bank whose settings they work with is left
    if (write.item == ItemId::TeachingMode && !m_teaching.isExecuting())
        m_teaching.interrupt();
    const Value before = m_memory.value(write.item);
    const Value triggerBefore = m_memory.value(ItemId::TriggerMode);
    store(write.item, write.value, m_memory);
    const bool triggerChanged = m_memory.value(ItemId::TriggerMode) != triggerBefore;
    if (triggerChanged || write.item == ItemId::BankSwitching)
        m_triggerByCommunication = false; // §4.6.2
    if (triggerChanged || (restartsMeasurement(write.item) && before != write.value))
        restartMeasurement();
    refresh();
    return true;
}

/// ON starts the procedure, again too; OFF ends one that runs and makes the adjustment automatic (§4.3.3).
bool VirtualSensor::writeBrightnessTuning(bool on, Operator by)
{
    if (on)
        return !startTuning(by).refusal;
    interruptTuning();
    m_memory.setValue(ItemId::BrightnessTuning, 0);
    refresh();
    return true;
}

/// Into the bank in use. §4.3.4: a hold mode other than None turns One Shot into Hold.
void VirtualSensor::store(ItemId id, Value value, SettingsMemory& memory) const
{
    const int bank = m_memory.bank();
    memory.setValue(id, value, bank);
    if (id == ItemId::HoldMode && value != 0)
        memory.setValue(ItemId::TriggerMode, 0, bank);
}

bool VirtualSensor::carryOutCommand(const ItemWrite& write, Operator by)
{
    switch (write.item) {
    case ItemId::SetValueSaving:
        return saveMemory(m_memory);
    case ItemId::MeasuredValueResetting:
        m_chain.reset();
        return true;
    case ItemId::BankCopy:
        return copyBank(write.value);
    case ItemId::SettingsInitialization:
        return initialize(write.value);
    case ItemId::TriggerInputCommunication:
        m_triggerByCommunication = write.value != 0;
        refresh();
        return true;
    case ItemId::ResettingCommunicationSettings:
        activateCommunication();
        Q_EMIT communicationReset();
        return true;
    case ItemId::ExecutionOfTeaching:
        return !(write.value != 0 ? startTeaching(by) : interruptTeaching()).refusal;
    case ItemId::Teaching1stPoint:
        return !takeTeachingPoint(1).refusal;
    case ItemId::Teaching2ndPoint:
        return !takeTeachingPoint(2).refusal;
    case ItemId::Teaching3rdPoint:
        return !takeTeachingPoint(3).refusal;
    case ItemId::BrightnessTuning1stPoint:
        return !takeTuningPoint(1).refusal;
    case ItemId::BrightnessTuning2ndPoint:
        return !takeTuningPoint(2).refusal;
    default:
        return false;
    }
}

bool VirtualSensor::setZero(bool on)
{
    const int bank = m_memory.bank();
    if (on && !(isMeasuring() && m_chain.measurable()))
        return false; // §4.10: not while the light cannot be measured, whatever is displayed
    m_memory.setValue(ItemId::ZeroSetting, on);
    // While indeterminate zero can be set, though the correction is anything (§4.10 note).
    m_memory.setZeroCorrection(bank, on ? m_chain.beforeZero().value_or(0) : 0);
    refresh();
    return true;
}

bool VirtualSensor::saveMemory(const SettingsMemory& memory)
{
    LifeCounters life = m_monitor.life;
    ++life.memoryWrites;
    if (m_store) {
        if (const auto stored = m_store(memory, life); !stored) {
            Q_EMIT storeFailed(stored.error());
            return false;
        }
    }
    m_saved = memory;
    m_monitor.life = life;
    ++m_memoryWrites;
    beSilentForMs(m_savingMs);
    Q_EMIT memoryWritten();
    return true;
}

/// §4.2: the settings *saved* in one bank become those of another, saved and in use.
bool VirtualSensor::copyBank(Value combination)
{
    const BankCopy copy = bankCopies.at(std::size_t(combination));
    SettingsMemory saved = m_saved;
    saved.copyBank(m_saved, copy.from, copy.to);
    if (!saveMemory(saved))
        return false;
    interruptProcedures();
    m_memory.copyBank(m_saved, copy.to, copy.to);
    breakOff();
    return true;
}

bool VirtualSensor::initialize(Value what)
{
    const auto reset = [what](SettingsMemory& memory) {
        if (what == allAreas)
            memory.initializeAllAreas();
        for (int bank = 0; bank < SettingsMemory::bankCount; ++bank) {
            if (what == allBanks || what == bank + 1)
                memory.initializeBank(bank);
        }
    };
    SettingsMemory saved = m_saved;
    reset(saved);
    if (!saveMemory(saved))
        return false;
    interruptProcedures();
    reset(m_memory);
    breakOff();
    return true;
}

/// After many values changed at once (§4.6.2 notes).
void VirtualSensor::breakOff()
{
    m_triggerByCommunication = false;
    restartMeasurement();
    refresh();
}

/// All of them with one write to the memory: an address is there whole or not at all.
bool VirtualSensor::saveItems(const QList<ItemId>& ids)
{
    const int bank = m_memory.bank();
    SettingsMemory saved = m_saved;
    for (const ItemId id : ids) {
        store(id, m_memory.value(id), saved);
        if (id == ItemId::ZeroSetting)
            saved.setZeroCorrection(bank, m_memory.zeroCorrection(bank));
        if (id == ItemId::BrightnessTuning)
            saved.setTunedBrightness(bank, m_memory.tunedBrightness(bank));
    }
    return saveMemory(saved);
}

void VirtualSensor::changeByKeypad(ItemId id, Value value)
{
    catchUp();
    if (!carryOut({id, value}, Operator::Keys))
        return;
    if (isSavedAtOnce(id))
        saveItems({id});
    Q_EMIT written(id, value);
}

void VirtualSensor::setInputPolarity(InputPolarity polarity)
{
    m_memory.setInputPolarity(polarity);
    SettingsMemory saved = m_saved;
    saved.setInputPolarity(polarity);
    saveMemory(saved);
}

void VirtualSensor::initializeSetValues()
{
    SettingsMemory saved = m_saved;
    saved.initializeSetValues();
    if (!saveMemory(saved))
        return;
    m_monitor.clear(131); // E131: what this helps against (§8.2)
    powerCycle();
}

} // namespace lds::emulator

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
    const auto judged = judgeWrites(m_memory, writes);
    if (!judged) {
        const QString key = QString::fromLatin1(hlG2(judged.error().item).key);
        return {0, Refusal::Data, key + QStringLiteral(": ") + judged.error().reason};
    }
    WriteOutcome outcome;
    for (const ItemWrite& write : *judged) {
        ++m_writeCounts[write.item];
        if (m_failing.contains(write.item) || !carryOut(write)) {
            outcome.refusal = Refusal::Failed;
            outcome.reason = QString::fromLatin1(hlG2(write.item).key) + QStringLiteral(": writing failed");
            return outcome;
        }
        ++outcome.written;
        Q_EMIT written(write.item, write.value);
    }
    return outcome;
}

bool VirtualSensor::carryOut(const ItemWrite& write)
{
    const SettingItem& item = hlG2(write.item);
    if (SettingsMemory::holds(item))
        return carryOutStored(write);
    return carryOutCommand(write);
}

bool VirtualSensor::carryOutStored(const ItemWrite& write)
{
    if (write.item == ItemId::BrightnessTuning && write.value != 0)
        return false; // tuning is not in this version
    if (write.item == ItemId::ZeroSetting)
        return setZero(write.value != 0);
    const Value before = m_memory.value(write.item);
    const Value triggerBefore = m_memory.value(ItemId::TriggerMode);
    store(write.item, write.value, m_memory);
    const bool triggerChanged = m_memory.value(ItemId::TriggerMode) != triggerBefore;
    if (triggerChanged || write.item == ItemId::BankSwitching)
        m_triggerByCommunication = false; // §4.6.2
    if (triggerChanged || (restartsMeasurement(write.item) && before != write.value))
        restartMeasurement();
    applySettings();
    takeSample(m_clock.nowNs());
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

bool VirtualSensor::carryOutCommand(const ItemWrite& write)
{
    switch (write.item) {
    case ItemId::SetValueSaving:
        return saveMemory(m_memory);
    case ItemId::MeasuredValueResetting:
        m_chain.restart();
        return true;
    case ItemId::BankCopy:
        return copyBank(write.value);
    case ItemId::SettingsInitialization:
        return initialize(write.value);
    case ItemId::TriggerInputCommunication:
        m_triggerByCommunication = write.value != 0;
        takeSample(m_clock.nowNs());
        return true;
    case ItemId::ResettingCommunicationSettings:
        activateCommunication();
        Q_EMIT communicationReset();
        return true;
    case ItemId::ExecutionOfTeaching:
        return write.value ==
               0; // interrupting what does not run is no error; starting is not in this version
    default:
        return false; // points of teaching and tuning, neither of which can have been started
    }
}

bool VirtualSensor::setZero(bool on)
{
    const int bank = m_memory.bank();
    if (on && !(laserEmitting() && m_light == Light::Measurable))
        return false; // §4.10: not while the light cannot be measured
    m_memory.setValue(ItemId::ZeroSetting, on);
    // While indeterminate zero can be set, though the correction is anything (§4.10 note).
    m_memory.setZeroCorrection(bank, on ? m_chain.beforeZero().value_or(0) : 0);
    applySettings();
    takeSample(m_clock.nowNs());
    return true;
}

bool VirtualSensor::saveMemory(const SettingsMemory& memory)
{
    if (m_store) {
        if (const auto stored = m_store(memory); !stored) {
            Q_EMIT storeFailed(stored.error());
            return false;
        }
    }
    m_saved = memory;
    ++m_memoryWrites;
    m_silentUntilNs = m_clock.nowNs() + m_savingMs * 1'000'000LL;
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
    reset(m_memory);
    breakOff();
    return true;
}

/// After many values changed at once (§4.6.2 notes).
void VirtualSensor::breakOff()
{
    m_triggerByCommunication = false;
    restartMeasurement();
    applySettings();
    takeSample(m_clock.nowNs());
}

void VirtualSensor::restartMeasurement()
{
    applySettings();
    m_chain.restart();
}

void VirtualSensor::activateCommunication()
{
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (item.effect == Effect::AfterCommunicationReset && SettingsMemory::holds(item))
            m_active.insert(item.id, m_memory.value(item.id));
    }
}

void VirtualSensor::changeByKeypad(ItemId id, Value value)
{
    catchUp();
    const SettingItem& item = hlG2(id);
    if (!carryOut({id, value}))
        return;
    if (SettingsMemory::holds(item)) {
        SettingsMemory saved = m_saved;
        store(id, value, saved);
        if (id == ItemId::ZeroSetting)
            saved.setZeroCorrection(m_memory.bank(), m_memory.zeroCorrection(m_memory.bank()));
        saveMemory(saved);
    }
    Q_EMIT written(id, value);
}

void VirtualSensor::powerCycle()
{
    m_memory = m_saved;
    m_inMenu = false;
    m_triggerByCommunication = false;
    m_silentUntilNs = 0;
    activateCommunication();
    restartMeasurement();
    m_sampledNs = m_clock.nowNs();
}

} // namespace lds::emulator

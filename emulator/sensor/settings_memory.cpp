#include "settings_memory.h"

#include <algorithm>

namespace lds::emulator {

using namespace catalog;

namespace {

Value factoryDefault(const SettingItem& item, SensorModel model)
{
    const Limits& limits = item.limitsFor(model);
    // Items without a printed default (switches, the bank) start at their first value: OFF, bank 1.
    return item.hasDefault ? limits.defaultValue : limits.minimum;
}

bool isCommunication(const SettingItem& item)
{
    return item.effect == Effect::AfterCommunicationReset || item.access == Access::None;
}

} // namespace

SettingsMemory::SettingsMemory(SensorModel model)
    : m_model(model)
{
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (holds(item) && item.scope == Scope::Common)
            m_common.insert(item.id, factoryDefault(item, model));
    }
    for (int bank = 0; bank < bankCount; ++bank)
        initializeBank(bank);
}

bool SettingsMemory::holds(const SettingItem& item)
{
    if (item.id == ItemId::TriggerInputCommunication || item.kind == Kind::MacAddress)
        return false;
    return item.access == Access::ReadWrite || item.access == Access::None;
}

bool SettingsMemory::isBanked(ItemId id) { return hlG2(id).scope == Scope::Bank; }

int SettingsMemory::bank() const
{
    return std::clamp(m_common.value(ItemId::BankSwitching) - 1, 0, bankCount - 1);
}

Value SettingsMemory::value(ItemId id) const { return value(id, bank()); }

Value SettingsMemory::value(ItemId id, int bank) const
{
    return isBanked(id) ? m_banks[std::size_t(bank)].values.value(id) : m_common.value(id);
}

void SettingsMemory::setValue(ItemId id, Value value) { setValue(id, value, bank()); }

void SettingsMemory::setValue(ItemId id, Value value, int bank)
{
    Q_ASSERT(holds(hlG2(id)));
    if (isBanked(id))
        m_banks[std::size_t(bank)].values.insert(id, value);
    else
        m_common.insert(id, value);
}

void SettingsMemory::setZeroCorrection(int bank, Nanometres correction)
{
    m_banks[std::size_t(bank)].zeroCorrection = correction;
}

std::optional<BrightnessRange> SettingsMemory::tunedBrightness(int bank) const
{
    return m_banks[std::size_t(bank)].tunedBrightness;
}

void SettingsMemory::setTunedBrightness(int bank, std::optional<BrightnessRange> range)
{
    m_banks[std::size_t(bank)].tunedBrightness = range;
}

void SettingsMemory::copyBank(const SettingsMemory& source, int from, int to)
{
    m_banks[std::size_t(to)] = source.m_banks[std::size_t(from)];
}

void SettingsMemory::initializeBank(int bank)
{
    Bank& target = m_banks[std::size_t(bank)];
    target.zeroCorrection = 0;
    target.tunedBrightness.reset();
    for (const SettingItem& item : Catalog::hlG2().items()) {
        if (holds(item) && item.scope == Scope::Bank)
            target.values.insert(item.id, factoryDefault(item, m_model));
    }
}

void SettingsMemory::initializeAllAreas()
{
    for (int bank = 0; bank < bankCount; ++bank)
        initializeBank(bank);
    for (auto entry = m_common.begin(); entry != m_common.end(); ++entry) {
        const SettingItem& item = hlG2(entry.key());
        if (item.id != ItemId::LanguageSetting && !isCommunication(item))
            entry.value() = factoryDefault(item, m_model);
    }
}

void SettingsMemory::initializeSetValues()
{
    initializeAllAreas();
    m_common[ItemId::LanguageSetting] = factoryDefault(hlG2(ItemId::LanguageSetting), m_model);
    m_inputPolarity = InputPolarity::Npn;
}

} // namespace lds::emulator

#include "catalog.h"

#include "hlg2_tables.h"

#include <algorithm>

namespace lds::catalog {
namespace {

template <typename Row>
const Row* pointerTo(std::span<const Row> rows, auto found)
{
    return found == rows.end() ? nullptr : &*found;
}

} // namespace

Catalog::Catalog(std::span<const SettingItem> items, std::span<const MenuEntry> menu,
                 std::span<const Coil> coils, std::span<const ModelDescription> models,
                 std::span<const int> prohibited)
    : m_items(items)
    , m_menu(menu)
    , m_coils(coils)
    , m_models(models)
    , m_prohibited(prohibited)
{
    for (const SettingItem& item : m_items) {
        if (item.modbus)
            m_byAddress.insert(item.modbus->address(), &item);
    }
}

const Catalog& Catalog::hlG2()
{
    static const Catalog catalog(hlg2::items(), hlg2::menu(), hlg2::coils(), hlg2::models(),
                                 hlg2::usageProhibitedRegisters());
    return catalog;
}

const SettingItem& Catalog::item(ItemId id) const
{
    const auto place = std::size_t(id);
    Q_ASSERT(place < m_items.size() && m_items[place].id == id);
    return m_items[place];
}

const SettingItem* Catalog::findByKey(QStringView key) const
{
    return pointerTo(m_items, std::ranges::find_if(m_items, [key](const SettingItem& item) {
                         return key == QLatin1StringView(item.key);
                     }));
}

const SettingItem* Catalog::findByModbusAddress(quint16 address) const
{
    return m_byAddress.value(address, nullptr);
}

const MenuEntry* Catalog::findMenu(int number) const
{
    return pointerTo(m_menu, std::ranges::find(m_menu, number, &MenuEntry::number));
}

const ModelDescription& Catalog::model(SensorModel model) const
{
    Q_ASSERT(m_models[std::size_t(model)].model == model);
    return m_models[std::size_t(model)];
}

const ModelDescription* Catalog::findModel(QStringView typeName) const
{
    return pointerTo(m_models, std::ranges::find_if(m_models, [typeName](const ModelDescription& model) {
                         return typeName.compare(QLatin1StringView(model.typeName), Qt::CaseInsensitive) == 0;
                     }));
}

bool Catalog::isUsageProhibited(quint16 address) const
{
    return std::ranges::find(m_prohibited, int(address) + 400001) != m_prohibited.end();
}

} // namespace lds::catalog

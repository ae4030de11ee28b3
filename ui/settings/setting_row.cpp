#include "setting_row.h"

#include "item_text.h"

#include <QCoreApplication>
#include <QHash>

namespace lds::ui {

using catalog::Role;

namespace {

SettingRow::Shape shapeOf(const QList<const catalog::SettingItem*>& items)
{
    if (items.isEmpty())
        return SettingRow::Shape::Heading;
    if (items.size() == 1)
        return SettingRow::Shape::Single;
    return items.constFirst()->group == catalog::WriteGroup::None ? SettingRow::Shape::Several
                                                                  : SettingRow::Shape::Octets;
}

} // namespace

QList<catalog::ItemId> SettingRow::ids() const
{
    QList<catalog::ItemId> ids;
    for (const auto* item : items)
        ids.append(item->id);
    return ids;
}

QString SettingRow::title() const
{
    if (entry)
        return menuName(*entry);
    return first() ? itemName(*first())
                   : QCoreApplication::translate("SettingsPage", "Without a menu number");
}

bool SettingRow::actsAtOnce() const
{
    return first() && first()->role != Role::Setting && first()->role != Role::Status;
}

QList<SettingRow::Order> SettingRow::orders(catalog::SensorModel model) const
{
    if (!actsAtOnce() || !first()->isWritable())
        return {};
    const catalog::SettingItem& item = *first();
    const bool isProcedure = item.role == Role::Procedure;
    if (isProcedure && !item.isReadable())
        return {}; // a step inside a procedure
    if (item.kind == catalog::Kind::Trigger)
        return {{0, QCoreApplication::translate("SettingsPage", "Execute now"), true}};
    QList<Order> orders;
    for (const auto& choice : item.choices) {
        if (choice.models & catalog::maskOf(model)) {
            const bool isWayBack = choice.code == item.limitsFor(model).defaultValue;
            orders.append({choice.code, choiceName(choice), !isProcedure || isWayBack});
        }
    }
    return orders;
}

SettingTree::SettingTree(const catalog::Catalog& catalog)
{
    addMenu(catalog);
    addUnnumbered(catalog);
}

SettingRow* SettingTree::add(std::unique_ptr<SettingRow> row, SettingRow* parent)
{
    auto& siblings = parent ? parent->children : m_top;
    row->parent = parent;
    row->position = int(siblings.size());
    row->shape = shapeOf(row->items);
    siblings.push_back(std::move(row));
    m_all.append(siblings.back().get());
    return siblings.back().get();
}

void SettingTree::addMenu(const catalog::Catalog& catalog)
{
    QHash<int, SettingRow*> byNumber;
    for (const auto& entry : catalog.menu()) {
        auto row = std::make_unique<SettingRow>();
        row->menu = entry.number;
        row->level = entry.level();
        row->entry = &entry;
        for (const auto id : entry.items)
            row->items.append(&catalog.item(id));
        byNumber.insert(entry.number, add(std::move(row), byNumber.value(entry.parent())));
    }
}

void SettingTree::addUnnumbered(const catalog::Catalog& catalog)
{
    QList<const catalog::SettingItem*> missing;
    for (const auto& item : catalog.items()) {
        if (item.isWritable() && item.role != Role::Status && !find(item.id))
            missing.append(&item);
    }
    if (missing.isEmpty())
        return;
    SettingRow* heading = add(std::make_unique<SettingRow>(), nullptr);
    for (const auto* item : missing) {
        auto row = std::make_unique<SettingRow>();
        row->items.append(item);
        add(std::move(row), heading);
    }
}

const SettingRow* SettingTree::find(catalog::ItemId item) const
{
    for (const auto* row : m_all) {
        for (const auto* candidate : row->items) {
            if (candidate->id == item)
                return row;
        }
    }
    return nullptr;
}

const SettingRow* SettingTree::findMenu(int number) const
{
    for (const auto* row : m_all) {
        if (row->menu == number)
            return row;
    }
    return nullptr;
}

} // namespace lds::ui

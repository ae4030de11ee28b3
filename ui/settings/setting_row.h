#pragma once

#include "catalog.h"

#include <memory>
#include <QList>
#include <QMetaType>
#include <vector>

namespace lds::ui {

/// A row of the settings tree: a heading of the sensor's menu, or one thing a person can set. Holds no
/// values; immutable once the tree is built, so that pointers to rows stay good as long as the tree.
struct SettingRow {
    enum class Shape : quint8 {
        Heading, ///< Groups its children; has no items.
        Single,  ///< One item.
        Octets,  ///< Four items that make one address, 1st octet first; judged and written together.
        Several, ///< Items that share a menu number and are set one by one (77).
    };

    int menu = 0;  ///< Menu number, 0 when the sensor's menu does not have it.
    int level = 0; ///< Hierarchy bars, 1 … 3; 0 without a menu number.
    Shape shape = Shape::Heading;
    const catalog::MenuEntry* entry = nullptr; ///< nullptr without a menu number.
    QList<const catalog::SettingItem*> items;
    const SettingRow* parent = nullptr; ///< nullptr at the top.
    int position = 0;                   ///< Among its siblings.
    std::vector<std::unique_ptr<SettingRow>> children;

    bool isHeading() const { return shape == Shape::Heading; }
    /// The item that stands for the row where one has to; nullptr for a heading.
    const catalog::SettingItem* first() const { return items.isEmpty() ? nullptr : items.constFirst(); }
    QList<catalog::ItemId> ids() const;
    QString title() const; ///< In the person's language.
    bool isSetting() const { return first() && first()->role == catalog::Role::Setting; }
    /// Acts as soon as it is used, and is never a pending edit: switches, commands, procedures.
    bool actsAtOnce() const;
    /// What can be ordered in the row itself, with the codes to send; empty for a setting or a status. Of
    /// a procedure only the way back is offered: starting one takes more than a row.
    struct Order {
        catalog::Value value;
        QString text;
        bool offered; ///< False: listed, so that nothing seems to be missing, and cannot be chosen.
    };
    QList<Order> orders(catalog::SensorModel model) const;
};

/// The rows of one family in the order of the sensor's menu, then what can be set and has no menu number.
class SettingTree {
public:
    explicit SettingTree(const catalog::Catalog& catalog);

    const std::vector<std::unique_ptr<SettingRow>>& top() const { return m_top; }
    const SettingRow* find(catalog::ItemId item) const; ///< nullptr for a status item: those are no rows.
    const SettingRow* findMenu(int number) const;
    /// Every row, parents before their children.
    const QList<const SettingRow*>& all() const { return m_all; }

private:
    SettingRow* add(std::unique_ptr<SettingRow> row, SettingRow* parent);
    void addMenu(const catalog::Catalog& catalog);
    void addUnnumbered(const catalog::Catalog& catalog);

    std::vector<std::unique_ptr<SettingRow>> m_top;
    QList<const SettingRow*> m_all;
};

} // namespace lds::ui
Q_DECLARE_METATYPE(const lds::ui::SettingRow*)

#include "review_table_model.h"

#include "item_text.h"
#include "theme.h"

#include <algorithm>
#include <QFont>

namespace lds::ui {

using catalog::ItemId;
using catalog::SettingItem;
using sensor::SensorSession;

namespace {

/// The items that are changed together with this one, in the order a person reads them.
QList<ItemId> together(const SensorSession& session, const SettingItem& item)
{
    if (item.group != catalog::WriteGroup::None) {
        if (const auto* entry = session.catalog().findMenu(item.menu))
            return QList<ItemId>(entry->items.begin(), entry->items.end());
    }
    return {item.id};
}

/// Values of the items as one text; an item without a value of its own takes what is held.
QString text(const SensorSession& session, const QList<ItemId>& items, bool wanted)
{
    QList<catalog::Value> values;
    for (const ItemId id : items) {
        const auto edit = session.pending().find(id);
        if (wanted && edit)
            values += edit->wanted;
        else if (const auto held = session.held(id))
            values += *held;
        else
            return QStringLiteral("?");
    }
    return items.size() == 1
               ? displayValue(session.catalog().item(items.first()), session.model(), values.first())
               : octetsText(values);
}

QString conflictNote(const SensorSession& session, const SettingItem& item, const sensor::PendingEdit& edit)
{
    if (!edit.conflict)
        return {};
    const auto bank = session.held(ItemId::BankSwitching);
    if (edit.bank && bank && *edit.bank != *bank)
        return ReviewTableModel::tr("made for bank %1, bank %2 is running").arg(*edit.bank).arg(*bank);
    return edit.baseKnown ? ReviewTableModel::tr("changed elsewhere, was %1")
                                .arg(displayValue(item, session.model(), edit.base))
                          : ReviewTableModel::tr("made before the sensor was read");
}

ReviewTableModel::Row makeRow(const SensorSession& session, const SettingItem& item)
{
    ReviewTableModel::Row row;
    row.items = together(session, item);
    row.menu = item.menu;
    const auto* entry = row.items.size() > 1 ? session.catalog().findMenu(item.menu) : nullptr;
    row.name = entry ? menuName(*entry) : itemName(item);
    row.held = text(session, row.items, false);
    row.wanted = text(session, row.items, true);
    if (item.kind != catalog::Kind::Choice)
        row.unit = settings::unitText(item);
    for (const ItemId id : row.items) {
        if (const auto edit = session.pending().find(id); edit && edit->conflict) {
            row.conflict = true;
            row.note = conflictNote(session, session.catalog().item(id), *edit);
        }
    }
    if (row.note.isEmpty() && item.effect == catalog::Effect::AfterCommunicationReset)
        row.note = ReviewTableModel::tr("takes effect after a communication reset");
    return row;
}

} // namespace

ReviewTableModel::ReviewTableModel(SensorSession& session, QObject* parent)
    : QAbstractTableModel(parent)
    , m_session(&session)
{
    connect(&session, &SensorSession::pendingChanged, this, &ReviewTableModel::rebuild);
    connect(&session, &SensorSession::heldChanged, this, &ReviewTableModel::rebuild);
    connect(&session, &SensorSession::identityChanged, this, &ReviewTableModel::rebuild);
    rebuild();
}

void ReviewTableModel::rebuild()
{
    beginResetModel();
    m_rows.clear();
    QList<ItemId> seen;
    if (m_session) {
        const auto& edits = m_session->pending().edits();
        for (auto edit = edits.begin(); edit != edits.end(); ++edit) {
            if (seen.contains(edit.key()))
                continue;
            m_rows += makeRow(*m_session, m_session->catalog().item(edit.key()));
            seen += m_rows.last().items;
        }
    }
    // As the sensor's menu has them: 421 stands behind 42, before 5.
    std::ranges::stable_sort(m_rows, {}, [](const Row& row) {
        return row.menu == 0 ? QStringLiteral("~") : QString::number(row.menu);
    });
    endResetModel();
}

int ReviewTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}
int ReviewTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ReviewTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= int(m_rows.size()))
        return {};
    const Row& row = m_rows.at(index.row());
    switch (role) {
    case Qt::DisplayRole:
        switch (index.column()) {
        case Menu:
            return row.menu == 0 ? QString() : QString::number(row.menu);
        case Item:
            return row.name;
        case Held:
            return row.held;
        case Wanted:
            return row.wanted;
        case Unit:
            return row.unit;
        case Note:
            return row.note;
        default:
            return {};
        }
    case Qt::TextAlignmentRole:
        return int((index.column() == Held || index.column() == Wanted ? Qt::AlignRight : Qt::AlignLeft) |
                   Qt::AlignVCenter);
    case Qt::FontRole: {
        QFont font;
        font.setBold(index.column() == Wanted);
        return font;
    }
    case Qt::ForegroundRole:
        if (index.column() == Unit)
            return color(ColorRole::Muted);
        if (index.column() == Note)
            return color(row.conflict ? ColorRole::Warning : ColorRole::Muted);
        return {};
    case Qt::DecorationRole:
        return index.column() == Note && row.conflict
                   ? QVariant(Theme::instance().icon(QStringLiteral("conflict"), ColorRole::Warning))
                   : QVariant();
    case Qt::ToolTipRole:
        return index.column() == Note ? row.note : QString();
    case Qt::AccessibleTextRole:
        return tr("%1: %2 becomes %3 %4").arg(row.name, row.held, row.wanted, row.unit);
    default:
        return {};
    }
}

QVariant ReviewTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int((section == Held || section == Wanted ? Qt::AlignRight : Qt::AlignLeft) |
                   Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Menu:
        return tr("Menu");
    case Item:
        return tr("Item");
    case Held:
        return tr("In the sensor");
    case Wanted:
        return tr("Will become");
    case Unit:
        return tr("Unit");
    default:
        return {};
    }
}

} // namespace lds::ui

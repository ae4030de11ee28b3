#include "settings_model.h"

#include "item_text.h"

#include <QSet>

namespace lds::ui {

using catalog::ItemId;
using sensor::SensorSession;

/// What pendingChanged() may change about a row; kept to find out which rows it did change.
struct SettingsModel::Snapshot {
    QString wanted;
    bool edited = false;
    bool conflict = false;
    QStringList problems;
    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

SettingsModel::SettingsModel(QObject* parent)
    : QAbstractItemModel(parent)
{}

SettingsModel::~SettingsModel() = default;

void SettingsModel::setSession(SensorSession* session)
{
    if (session == m_session)
        return;
    beginResetModel();
    if (m_session) {
        // Its destruction is still listened to: what was typed for it is kept until then.
        disconnect(m_session, nullptr, this, nullptr);
        connect(m_session, &QObject::destroyed, this, [this](const QObject* gone) { forget(gone); });
    }
    m_session = session;
    m_tree.reset();
    m_problems.clear();
    m_snapshots.clear();
    if (session) {
        auto& tree = m_trees[&session->catalog()];
        if (!tree)
            tree = std::make_shared<SettingTree>(session->catalog());
        m_tree = tree;
        m_problems = session->problems();
        takeSnapshots();
        follow();
    }
    endResetModel();
}

void SettingsModel::follow()
{
    connect(m_session, &SensorSession::heldChanged, this, &SettingsModel::heldChanged);
    connect(m_session, &SensorSession::pendingChanged, this, &SettingsModel::pendingChanged);
    connect(m_session, &SensorSession::connectionChanged, this, &SettingsModel::everythingChanged);
    connect(m_session, &SensorSession::identityChanged, this, &SettingsModel::everythingChanged);
    connect(m_session, &SensorSession::busyChanged, this, &SettingsModel::everythingChanged);
    connect(m_session, &SensorSession::readinessChanged, this, &SettingsModel::everythingChanged);
    connect(m_session, &QObject::destroyed, this, [this](const QObject* gone) {
        forget(gone);
        beginResetModel();
        m_session = nullptr;
        m_tree.reset();
        m_snapshots.clear();
        endResetModel();
    });
}

void SettingsModel::forget(const QObject* session) { m_wrongInputs.remove(session); }

const SettingRow* SettingsModel::row(const QModelIndex& index) const
{
    return index.isValid() ? static_cast<const SettingRow*>(index.constInternalPointer()) : nullptr;
}

QModelIndex SettingsModel::indexOf(const SettingRow* row, int column) const
{
    return row ? createIndex(row->position, column, row) : QModelIndex();
}

QModelIndex SettingsModel::indexOf(ItemId item, int column) const
{
    return m_tree ? indexOf(m_tree->find(item), column) : QModelIndex();
}

int SettingsModel::rowCount(const QModelIndex& parent) const
{
    if (!m_tree || parent.column() > 0)
        return 0;
    const SettingRow* row = this->row(parent);
    return int(row ? row->children.size() : m_tree->top().size());
}

int SettingsModel::columnCount(const QModelIndex&) const { return ColumnCount; }

QModelIndex SettingsModel::index(int position, int column, const QModelIndex& parent) const
{
    if (!hasIndex(position, column, parent))
        return {};
    const SettingRow* above = row(parent);
    const auto& siblings = above ? above->children : m_tree->top();
    return createIndex(position, column, siblings.at(std::size_t(position)).get());
}

QModelIndex SettingsModel::parent(const QModelIndex& child) const
{
    const SettingRow* row = this->row(child);
    return row ? indexOf(row->parent) : QModelIndex();
}

Qt::ItemFlags SettingsModel::flags(const QModelIndex& index) const
{
    const SettingRow* row = this->row(index);
    if (!row || !m_session)
        return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (row->children.empty())
        flags |= Qt::ItemNeverHasChildren;
    if (index.column() == NewValue && RowFacts(*row, *m_session).isEditable())
        flags |= Qt::ItemIsEditable;
    return flags;
}

SettingsModel::RowStates SettingsModel::states(const SettingRow& row) const
{
    RowStates states;
    if (!m_session || row.isHeading())
        return states;
    const RowFacts facts(row, *m_session);
    states.setFlag(Edited, facts.isEdited());
    states.setFlag(Conflict, facts.hasConflict());
    states.setFlag(Problem, !m_snapshots.value(&row).problems.isEmpty());
    states.setFlag(Stale, facts.isStale());
    states.setFlag(Missing, !facts.isKnown());
    states.setFlag(Unusable, !(row.isSetting() ? facts.isEditable() : facts.isUsable()));
    states.setFlag(WrongText, !wrongInput(row).text.isEmpty());
    return states;
}

QStringList SettingsModel::problems(const SettingRow& row) const
{
    return m_session ? RowFacts(row, *m_session).problemSentences(m_problems) : QStringList();
}

QVariant SettingsModel::data(const QModelIndex& index, int role) const
{
    const SettingRow* row = this->row(index);
    if (!row || !m_session)
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return displayText(*row, index.column());
    case Qt::ToolTipRole:
        return toolTip(*row, index.column());
    case Qt::AccessibleTextRole:
        return accessibleText(*row, index.column());
    case Qt::AccessibleDescriptionRole:
        return row->first() ? itemHelp(*row->first()) : QString();
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter |
                   (index.column() == InSensor || index.column() == NewValue || index.column() == Default
                        ? Qt::AlignRight
                        : Qt::AlignLeft));
    case RowRole:
        return QVariant::fromValue(row);
    case StateRole:
        return int(states(*row));
    case ButtonRole:
        return index.column() == NewValue ? buttonText(*row) : QString();
    default:
        return {};
    }
}

QVariant SettingsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    const bool isValue = section == InSensor || section == NewValue || section == Default;
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isValue ? Qt::AlignRight : Qt::AlignLeft));
    if (role == Qt::ToolTipRole && section == InSensor && m_session && m_session->isStale())
        return tr("Not connected: these are the values read last, not what the sensor holds now.");
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Menu:
        return tr("Menu");
    case Item:
        return tr("Item");
    case InSensor:
        return m_session && m_session->isStale() ? tr("Last known") : tr("In the sensor");
    case NewValue:
        return tr("New value");
    case Unit:
        return tr("Unit");
    case Range:
        return tr("Range");
    case Default:
        return tr("Default");
    default:
        return {};
    }
}

QString SettingsModel::displayText(const SettingRow& row, int column) const
{
    if (column == Menu)
        return row.menu ? QString::number(row.menu) : QString();
    if (column == Item)
        return row.title();
    if (row.isHeading())
        return {};
    const RowFacts facts(row, *m_session);
    switch (column) {
    case InSensor:
        if (facts.isKnown())
            return facts.heldText();
        return isStep(row) ? tr("step of a procedure") : facts.missingWord();
    case NewValue:
        return newValueText(row);
    case Unit:
        return facts.unit();
    case Range:
        return rangeColumnText(row);
    case Default:
        return facts.defaultText();
    default:
        return {};
    }
}

QString SettingsModel::newValueText(const SettingRow& row) const
{
    if (const auto wrong = wrongInput(row); !wrong.text.isEmpty())
        return wrong.text;
    return row.isSetting() ? RowFacts(row, *m_session).wantedText() : QString();
}

/// Belongs inside a procedure and means nothing outside it: shown, so that nothing seems to be missing.
bool SettingsModel::isStep(const SettingRow& row) const
{
    return row.actsAtOnce() && row.orders(m_session->model()).isEmpty();
}

QString SettingsModel::buttonText(const SettingRow& row) const
{
    const auto orders = row.orders(m_session->model());
    if (orders.isEmpty() || !m_session->reaches(row.first()->id))
        return {};
    if (orders.size() == 1)
        return orders.constFirst().text;
    return row.first()->isReadable() ? tr("Change now") : tr("Execute now");
}

QString SettingsModel::rangeColumnText(const SettingRow& row) const
{
    const QString range = RowFacts(row, *m_session).range();
    if (!row.actsAtOnce())
        return range;
    if (row.first()->role == catalog::Role::Procedure)
        return isStep(row) ? QString() : tr("starts a procedure");
    // A long list of choices says little when it is cut; the button lists them.
    return tr("acts at once");
}

QString SettingsModel::toolTip(const SettingRow& row, int column) const
{
    if (row.isHeading())
        return {};
    const RowFacts facts(row, *m_session);
    QStringList lines;
    if (const auto wrong = wrongInput(row); !wrong.text.isEmpty())
        lines += wrong.message;
    if (facts.hasConflict())
        lines += tr("The sensor's value has changed to %1 since this edit was made.").arg(facts.heldText());
    lines += problems(row);
    if (column == InSensor && facts.isStale())
        lines += tr("Not connected: read last, not what the sensor holds now.");
    if (column == InSensor || column == NewValue)
        lines += facts.whyNot();
    if (column == Range)
        lines += facts.range();
    if (column == Item && lines.isEmpty())
        lines += row.title();
    lines.removeAll(QString());
    return lines.join(u'\n');
}

QString SettingsModel::accessibleText(const SettingRow& row, int column) const
{
    const QString value = displayText(row, column);
    if (column == Menu)
        return row.menu ? tr("Menu %1, level %2").arg(row.menu).arg(row.level) : row.title();
    if (column == Item || row.isHeading())
        return row.title();
    QStringList parts{tr("%1, %2: %3")
                          .arg(row.title(), headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(),
                               value.isEmpty() ? buttonText(row) : value)};
    const RowStates states = this->states(row);
    if (column == InSensor && states.testFlag(Stale))
        parts += tr("not connected");
    if (column == NewValue) {
        if (states.testFlag(Edited))
            parts += tr("changed");
        if (states.testFlag(Conflict))
            parts += tr("the sensor's value has changed too");
        if (states.testFlag(Problem))
            parts += tr("breaks a rule");
        if (states.testFlag(WrongText))
            parts += tr("is not a value");
        if (row.actsAtOnce() && !buttonText(row).isEmpty())
            parts += tr("acts at once");
    }
    return parts.join(QStringLiteral(", "));
}

QString SettingsModel::searchText(const SettingRow& row) const
{
    QStringList parts{row.title()};
    if (row.menu)
        parts += QString::number(row.menu);
    if (!row.isHeading() && m_session) {
        const RowFacts facts(row, *m_session);
        for (const auto* item : row.items)
            parts << itemName(*item) << QString::fromLatin1(item->key) << itemHelp(*item);
        parts << valueTexts(row) << facts.unit();
    }
    // A person types a hyphen where the screen shows a minus sign.
    return parts.join(u'\n').toLower().replace(QChar(0x2212), u'-');
}

QStringList SettingsModel::valueTexts(const SettingRow& row) const
{
    if (row.isHeading() || !m_session)
        return {};
    return {RowFacts(row, *m_session).heldText(), newValueText(row)};
}

void SettingsModel::keepWrongInput(const SettingRow& row, const WrongInput& input)
{
    if (!m_session)
        return;
    auto& inputs = m_wrongInputs[m_session];
    if (input.text.isEmpty()) {
        if (!inputs.remove(&row))
            return;
    } else {
        inputs.insert(&row, input);
    }
    rowChanged(row);
}

SettingsModel::WrongInput SettingsModel::wrongInput(const SettingRow& row) const
{
    return m_wrongInputs.value(m_session).value(&row);
}

bool SettingsModel::hasWrongInput() const { return !m_wrongInputs.value(m_session).isEmpty(); }

void SettingsModel::heldChanged(const QList<ItemId>& items)
{
    QSet<const SettingRow*> rows;
    for (const ItemId item : items) {
        if (const SettingRow* row = m_tree->find(item))
            rows.insert(row);
    }
    for (const SettingRow* row : rows)
        rowChanged(*row);
    // A value that moved may break or mend a rule among the edits of other rows.
    if (!m_session->pending().isEmpty() || !m_problems.isEmpty())
        pendingChanged();
}

void SettingsModel::pendingChanged()
{
    m_problems = m_session->problems();
    for (const SettingRow* row : m_tree->all()) {
        Snapshot now = snapshot(*row);
        if (m_snapshots.value(row) == now)
            continue;
        m_snapshots.insert(row, std::move(now));
        rowChanged(*row);
    }
}

void SettingsModel::everythingChanged()
{
    takeSnapshots();
    Q_EMIT headerDataChanged(Qt::Horizontal, InSensor, InSensor);
    for (const SettingRow* row : m_tree->all())
        rowChanged(*row);
}

void SettingsModel::rowChanged(const SettingRow& row)
{
    Q_EMIT dataChanged(indexOf(&row, Menu), indexOf(&row, ColumnCount - 1));
}

SettingsModel::Snapshot SettingsModel::snapshot(const SettingRow& row) const
{
    if (row.isHeading())
        return {};
    const RowFacts facts(row, *m_session);
    return {facts.wantedText(), facts.isEdited(), facts.hasConflict(), facts.problemSentences(m_problems)};
}

void SettingsModel::takeSnapshots()
{
    m_problems = m_session->problems();
    for (const SettingRow* row : m_tree->all())
        m_snapshots.insert(row, snapshot(*row));
}

} // namespace lds::ui

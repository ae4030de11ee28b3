#include "scan_findings_model.h"

#include "serial_texts.h"
#include "theme.h"

namespace lds::ui {

using ports::ScanFinding;

namespace {

bool isSensor(const ScanFinding& finding) { return finding.kind == ScanFinding::Kind::Sensor; }

QIcon iconOf(ScanFinding::Kind kind)
{
    const Theme& theme = Theme::instance();
    switch (kind) {
    case ScanFinding::Kind::Sensor:
        return theme.icon(QStringLiteral("state-ok"), ColorRole::Go);
    case ScanFinding::Kind::OtherDevice:
        return theme.icon(QStringLiteral("state-offline"), ColorRole::Muted);
    case ScanFinding::Kind::TwoUnits:
    case ScanFinding::Kind::Noise:
        return theme.icon(QStringLiteral("state-warning"), ColorRole::Warning);
    }
    return {};
}

} // namespace

int ScanFindingsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int ScanFindingsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(ColumnCount);
}

QVariant ScanFindingsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const Row& row = m_rows.at(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::DecorationRole:
        return index.column() == Found ? iconOf(row.finding.kind) : QIcon();
    case Qt::CheckStateRole:
        if (index.column() != Address || !isSensor(row.finding) || row.inList)
            return {};
        return int(row.ticked ? Qt::Checked : Qt::Unchecked);
    case Qt::ToolTipRole:
        return findingAdvice(row.finding);
    case Qt::AccessibleTextRole:
        return QStringLiteral("%1, %2, %3").arg(text(row, Address), text(row, Found), text(row, Settings));
    default:
        return {};
    }
}

QString ScanFindingsModel::text(const Row& row, int column) const
{
    switch (column) {
    case Address:
        return row.finding.unit == 0 ? QStringLiteral("\u2013") : QString::number(row.finding.unit);
    case Found:
        return findingWord(row.finding);
    case Settings:
        return serialText(row.finding.serial);
    case Note:
        return row.inList ? tr("in the list") : findingAdvice(row.finding);
    default:
        return {};
    }
}

bool ScanFindingsModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::CheckStateRole || !(flags(index) & Qt::ItemIsUserCheckable))
        return false;
    m_rows[index.row()].ticked = value.toInt() == Qt::Checked;
    Q_EMIT dataChanged(index, index, {role});
    Q_EMIT tickedChanged();
    return true;
}

Qt::ItemFlags ScanFindingsModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (index.isValid() && index.column() == Address && isSensor(m_rows.at(index.row()).finding) &&
        !m_rows.at(index.row()).inList)
        flags |= Qt::ItemIsUserCheckable;
    return flags;
}

QVariant ScanFindingsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Address:
        return tr("Address");
    case Found:
        return tr("Found");
    case Settings:
        return tr("Speed, parity and stop bits");
    case Note:
        return tr("Note");
    default:
        return {};
    }
}

void ScanFindingsModel::clear()
{
    beginResetModel();
    m_rows.clear();
    endResetModel();
    Q_EMIT tickedChanged();
}

void ScanFindingsModel::add(const ScanFinding& finding, bool inList)
{
    const int row = int(m_rows.size());
    beginInsertRows({}, row, row);
    m_rows.append({finding, inList, isSensor(finding) && !inList});
    endInsertRows();
    Q_EMIT tickedChanged();
}

QList<ScanFinding> ScanFindingsModel::ticked() const
{
    QList<ScanFinding> findings;
    for (const Row& row : m_rows) {
        if (row.ticked)
            findings.append(row.finding);
    }
    return findings;
}

} // namespace lds::ui

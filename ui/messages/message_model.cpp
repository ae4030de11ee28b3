#include "message_model.h"

#include "message_text.h"
#include "sentences.h"

#include <algorithm>

namespace lds::ui {

namespace {

// As many as any screen shows; the details have them all.
constexpr qsizetype mostBytesInRow = 96;

} // namespace

MessageModel::MessageModel(const MessageStore::Bounds& bounds, QObject* parent)
    : QAbstractTableModel(parent)
    , m_store(bounds)
{}

void MessageModel::append(const QList<ports::Frame>& frames)
{
    std::vector<MessageStore::Key> accepted;
    for (const ports::Frame& frame : frames) {
        const MessageStore::Key key = m_store.append(frame);
        if (m_filter.accepts(frame))
            accepted.push_back(key);
    }
    if (!accepted.empty()) {
        const int first = rowCount();
        beginInsertRows({}, first, first + int(accepted.size()) - 1);
        m_rows.insert(m_rows.end(), accepted.begin(), accepted.end());
        endInsertRows();
    }
    const quint64 before = m_store.trimmed();
    m_store.trim();
    if (m_store.trimmed() != before)
        removeTrimmedRows();
}

/// The oldest polls may lie between other messages, so the rows that went are found run by run.
void MessageModel::removeTrimmedRows()
{
    std::size_t row = 0;
    while (row < m_rows.size()) {
        std::size_t end = row;
        while (end < m_rows.size() && !m_store.contains(m_rows[end]))
            ++end;
        if (end == row) {
            ++row;
            continue;
        }
        beginRemoveRows({}, int(row), int(end) - 1);
        m_rows.erase(m_rows.begin() + std::ptrdiff_t(row), m_rows.begin() + std::ptrdiff_t(end));
        endRemoveRows();
    }
}

void MessageModel::clear()
{
    beginResetModel();
    m_store.clear();
    m_rows.clear();
    endResetModel();
}

void MessageModel::setFilter(const MessageFilter& filter)
{
    if (filter == m_filter)
        return;
    beginResetModel();
    m_filter = filter;
    m_rows.clear();
    for (const MessageStore::Key& key : m_store.keys()) {
        if (m_filter.accepts(m_store.frame(key)))
            m_rows.push_back(key);
    }
    endResetModel();
}

std::optional<int> MessageModel::rowOf(const MessageStore::Key& key) const
{
    const auto found =
        std::lower_bound(m_rows.begin(), m_rows.end(), key,
                         [](const auto& one, const auto& other) { return one.sequence < other.sequence; });
    if (found == m_rows.end() || *found != key)
        return std::nullopt;
    return int(found - m_rows.begin());
}

int MessageModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}

int MessageModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QVariant MessageModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const ports::Frame& frame = frameAt(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return text(frame, index.column());
    case Qt::AccessibleTextRole:
        return index.column() == DirectionColumn ? directionWord(frame.direction)
                                                 : text(frame, index.column());
    case Qt::ToolTipRole:
        if (index.column() == BytesColumn)
            return reconstructedNote(frame);
        return index.column() == DirectionColumn ? directionWord(frame.direction) : QVariant();
    case Qt::TextAlignmentRole:
        if (index.column() == RoundTripColumn)
            return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
        return index.column() == DirectionColumn ? QVariant::fromValue(Qt::Alignment(Qt::AlignCenter))
                                                 : QVariant();
    case ReconstructedRole:
        return frame.reconstructedPrefix;
    case FailureRole:
        return isFailure(frame);
    default:
        return {};
    }
}

QString MessageModel::text(const ports::Frame& frame, int column) const
{
    switch (column) {
    case TimeColumn:
        return messageTime(frame);
    case DirectionColumn:
        return directionSign(frame.direction);
    case RoundTripColumn:
        return roundTripText(frame);
    case MessageColumn:
        return frameSentence(frame);
    case BytesColumn:
        return frame.bytes.size() > mostBytesInRow
                   ? hexText(frame.bytes.left(mostBytesInRow)) + QStringLiteral(" …")
                   : hexText(frame.bytes);
    case SensorColumn:
        return frame.peer;
    default:
        return {};
    }
}

QVariant MessageModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole) {
        if (section == DirectionColumn)
            return QVariant::fromValue(Qt::Alignment(Qt::AlignCenter));
        return QVariant::fromValue((section == RoundTripColumn ? Qt::AlignRight : Qt::AlignLeft) |
                                   Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole && section == RoundTripColumn)
        return tr("Milliseconds from the request to its answer");
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case TimeColumn:
        return tr("Time");
    case DirectionColumn:
        return tr("Way");
    case RoundTripColumn:
        return tr("ms");
    case MessageColumn:
        return tr("Message");
    case BytesColumn:
        return tr("Bytes");
    case SensorColumn:
        return tr("Sensor");
    default:
        return {};
    }
}

} // namespace lds::ui

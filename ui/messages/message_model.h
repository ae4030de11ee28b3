#pragma once

#include "message_filter.h"
#include "message_store.h"

#include <deque>
#include <optional>
#include <QAbstractTableModel>

namespace lds::ui {

/// The kept messages that pass the filter, newest last. Filters by itself: a proxy would map every row of
/// a log that grows by hundreds a second. Texts are made when a row is looked at, not when it arrives.
class MessageModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        TimeColumn,
        DirectionColumn,
        RoundTripColumn,
        MessageColumn,
        BytesColumn,
        SensorColumn,
        ColumnCount
    };
    enum Role {
        ReconstructedRole = Qt::UserRole, ///< int: this many leading bytes are reconstructed.
        FailureRole,                      ///< bool
    };

    explicit MessageModel(const MessageStore::Bounds& bounds = {}, QObject* parent = nullptr);

    void append(const QList<ports::Frame>& frames); ///< One change of the model however many there are.
    void clear();
    void setFilter(const MessageFilter& filter);
    const MessageFilter& filter() const { return m_filter; }

    const ports::Frame& frameAt(int row) const { return m_store.frame(m_rows[std::size_t(row)]); }
    MessageStore::Key keyAt(int row) const { return m_rows[std::size_t(row)]; }
    std::optional<int> rowOf(const MessageStore::Key& key) const; ///< Nothing when filtered out or gone.
    const MessageStore& store() const { return m_store; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void removeTrimmedRows();
    QString text(const ports::Frame& frame, int column) const;

    MessageStore m_store;
    MessageFilter m_filter;
    std::deque<MessageStore::Key> m_rows; ///< What passes the filter, in order of arrival.
};

} // namespace lds::ui

#pragma once

#include <QFont>
#include <QStyledItemDelegate>

namespace lds::ui {

/// A cell of the table: rows are chosen as a whole, so no single cell is framed.
class CellDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

/// Bytes in hexadecimal, the reconstructed ones in front dimmed.
class BytesDelegate final : public CellDelegate {
    Q_OBJECT

public:
    using CellDelegate::CellDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

/// What a message says; a failure is marked by shape and colour.
class SentenceDelegate final : public CellDelegate {
    Q_OBJECT

public:
    using CellDelegate::CellDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

QFont bytesFont(); ///< Of one width, so that bytes stand under each other.

} // namespace lds::ui

#pragma once

#include <QFont>
#include <QStyledItemDelegate>

namespace lds::ui {

/// Bytes in hexadecimal, the reconstructed ones in front dimmed.
class BytesDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

/// What a message says; a failure is marked by shape and colour.
class SentenceDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

QFont bytesFont(); ///< Of one width, so that bytes stand under each other.

} // namespace lds::ui

#pragma once

#include <QStyledItemDelegate>

namespace lds::ui {

/// Draws a sensor of the list: state by shape, name, type and trouble, URL.
class SensorDelegate final : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace lds::ui

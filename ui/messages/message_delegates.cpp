#include "message_delegates.h"

#include "message_model.h"
#include "theme.h"

#include <QApplication>
#include <QPainter>

namespace lds::ui {

void BytesDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const
{
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    item.text.clear();
    const QStyle* style = item.widget ? item.widget->style() : QApplication::style();
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);

    painter->save();
    painter->setFont(bytesFont());
    const QFontMetrics metrics = painter->fontMetrics();
    const QRect area = option.rect.adjusted(2 * Theme::unit, 0, -Theme::unit, 0);
    const QString whole =
        metrics.elidedText(index.data(Qt::DisplayRole).toString(), Qt::ElideRight, area.width());
    const auto dimmed = qsizetype(index.data(MessageModel::ReconstructedRole).toInt()) * 3; // "00 "
    const QString prefix = whole.left(dimmed);
    painter->setPen(color(ColorRole::DisplayDim));
    painter->drawText(area, Qt::AlignLeft | Qt::AlignVCenter, prefix);
    painter->setPen(color(ColorRole::Text));
    painter->drawText(area.adjusted(metrics.horizontalAdvance(prefix), 0, 0, 0),
                      Qt::AlignLeft | Qt::AlignVCenter, whole.mid(dimmed));
    painter->restore();
}

void SentenceDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    if (!index.data(MessageModel::FailureRole).toBool())
        return;
    option->text.prepend(QStringLiteral("▲ "));
    option->palette.setColor(QPalette::Text, color(ColorRole::Error));
    option->palette.setColor(QPalette::HighlightedText, color(ColorRole::Error));
}

QFont bytesFont()
{
    QFont font = Theme::instance().displayFont(12);
    font.setWeight(QFont::Normal);
    return font;
}

} // namespace lds::ui

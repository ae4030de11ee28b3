#include "message_delegates.h"

#include "message_model.h"
#include "theme.h"

#include <QApplication>
#include <QPainter>

namespace lds::ui {

namespace {

constexpr int headingRoom = 2 * Theme::unit; ///< Around a heading, as the style sheet has it.

const QStyle* styleOf(const QStyleOptionViewItem& item)
{
    return item.widget ? item.widget->style() : QApplication::style();
}

} // namespace

void CellDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    option->state.setFlag(QStyle::State_HasFocus, false);
}

/// The ground fills the cell; the text stands under its heading, which has more room around it.
void CellDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const
{
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    const QStyle* style = styleOf(item);
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &item, painter, item.widget);
    const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, &item, item.widget) + 1;
    item.rect.adjust(headingRoom - margin, 0, margin - headingRoom, 0);
    item.state.setFlag(QStyle::State_Selected, false);
    item.state.setFlag(QStyle::State_MouseOver, false);
    style->drawControl(QStyle::CE_ItemViewItem, &item, painter, item.widget);
}

void BytesDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const
{
    QStyleOptionViewItem item = option;
    initStyleOption(&item, index);
    styleOf(item)->drawPrimitive(QStyle::PE_PanelItemViewItem, &item, painter, item.widget);

    painter->save();
    painter->setFont(bytesFont());
    const QFontMetrics metrics = painter->fontMetrics();
    const QRect area = option.rect.adjusted(headingRoom, 0, -Theme::unit, 0);
    const QString whole = metrics.elidedText(item.text, Qt::ElideRight, area.width());
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
    CellDelegate::initStyleOption(option, index);
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

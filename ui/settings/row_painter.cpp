#include "row_painter.h"

#include "hierarchy_bars.h"
#include "setting_row.h"
#include "settings_model.h"
#include "theme.h"

#include <QPainter>

namespace lds::ui::row_painter {

using Column = SettingsModel::Column;
using States = SettingsModel::RowStates;

namespace {

constexpr int barWidth = 3;
constexpr int mostDecimals = 4; ///< 0.1 µm and 1/10000

const SettingRow& rowOf(const QModelIndex& index)
{
    return *index.data(SettingsModel::RowRole).value<const SettingRow*>();
}

States statesOf(const QModelIndex& index) { return States(index.data(SettingsModel::StateRole).toInt()); }

QFont fontOf(const QStyleOptionViewItem& option, const QModelIndex& index)
{
    QFont font = option.font;
    const States states = statesOf(index);
    const bool isNew = index.column() == SettingsModel::NewValue;
    if (rowOf(index).isHeading() || (isNew && states.testFlag(SettingsModel::Edited)))
        font.setWeight(QFont::DemiBold);
    const bool notLive = states & (SettingsModel::Stale | SettingsModel::Missing);
    const bool isWanted = states & (SettingsModel::Edited | SettingsModel::WrongText);
    if (notLive && (index.column() == SettingsModel::InSensor || (isNew && !isWanted)))
        font.setItalic(true);
    return font;
}

ColorRole textRole(const QModelIndex& index)
{
    const States states = statesOf(index);
    switch (index.column()) {
    case SettingsModel::Menu:
    case SettingsModel::Item:
        return ColorRole::Text;
    case SettingsModel::InSensor:
        return states & (SettingsModel::Stale | SettingsModel::Missing) ? ColorRole::Muted : ColorRole::Text;
    case SettingsModel::NewValue:
        if (states.testFlag(SettingsModel::WrongText))
            return ColorRole::Error;
        return states.testFlag(SettingsModel::Edited) ? ColorRole::Text : ColorRole::Muted;
    default:
        return ColorRole::Muted;
    }
}

/// The most urgent mark of a row, shown beside its new value: an icon of the theme and its colour.
std::pair<QString, ColorRole> markOf(States states)
{
    if (states.testFlag(SettingsModel::WrongText))
        return {QStringLiteral("state-error"), ColorRole::Error};
    if (states.testFlag(SettingsModel::Conflict))
        return {QStringLiteral("conflict"), ColorRole::Warning};
    if (states.testFlag(SettingsModel::Problem))
        return {QStringLiteral("state-warning"), ColorRole::Warning};
    return {};
}

bool isValueColumn(int column)
{
    return column == SettingsModel::InSensor || column == SettingsModel::NewValue ||
           column == SettingsModel::Default;
}

/// Lengths and factors stand with their points under each other, whatever decimals the type has.
int pointPadding(const QString& text, const SettingRow& row, const QFontMetrics& metrics)
{
    const auto kind = row.first() ? row.first()->kind : catalog::Kind::Choice;
    if (kind != catalog::Kind::Length && kind != catalog::Kind::Factor)
        return 0;
    const qsizetype point = text.indexOf(u'.');
    const int decimals = point < 0 ? 0 : int(text.size() - point - 1);
    return decimals >= mostDecimals ? 0 : (mostDecimals - decimals) * metrics.horizontalAdvance(u'0');
}

int menuNumberWidth(const QStyleOptionViewItem& option)
{
    return option.fontMetrics.horizontalAdvance(QStringLiteral("000")) + 2 * Theme::unit;
}

int buttonWidth(const QStyleOptionViewItem& option, const QString& text)
{
    return option.fontMetrics.horizontalAdvance(text) + 2 * padding + Theme::unit + iconSize;
}

/// On the baseline of the cell's own font: a sign that comes from another font must not move the figures.
void paintText(QPainter* painter, const QRect& rect, Qt::Alignment alignment, const QString& text)
{
    const QFontMetrics metrics(painter->font());
    const int spare = rect.width() - metrics.horizontalAdvance(text);
    const int x = rect.left() + (alignment.testFlag(Qt::AlignRight) ? spare : 0);
    const int y = rect.top() + (rect.height() - metrics.height()) / 2 + metrics.ascent();
    painter->drawText(QPoint(x, y), text);
}

void paintMenuCell(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index)
{
    const SettingRow& row = rowOf(index);
    if (!row.menu)
        return;
    const QString number = QString::number(row.menu);
    paintText(painter, option.rect, Qt::AlignLeft, number);
    // All bars begin at one place, so that the levels can be read down the column.
    QRect bars = option.rect;
    bars.setLeft(bars.left() + menuNumberWidth(option));
    paintHierarchyBars(painter, bars, row.level);
}

void paintButton(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index)
{
    const QRect rect = buttonRect(option, index);
    const bool usable = !statesOf(index).testFlag(SettingsModel::Unusable);
    const bool hovered = usable && option.state.testFlag(QStyle::State_MouseOver);
    painter->setFont(option.font);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(color(ColorRole::Line));
    painter->setBrush(color(hovered ? ColorRole::Hover : ColorRole::Panel));
    painter->drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    painter->setPen(color(usable ? ColorRole::Text : ColorRole::Muted));
    const QRect inside = rect.adjusted(padding, 0, -padding, 0);
    painter->drawText(inside, Qt::AlignVCenter | Qt::AlignLeft,
                      index.data(SettingsModel::ButtonRole).toString());
    const QRect arrow(inside.right() - iconSize + 3, inside.center().y() - iconSize / 2 + 1, iconSize,
                      iconSize);
    Theme::instance()
        .icon(QStringLiteral("chevron-down"), usable ? ColorRole::Text : ColorRole::Muted)
        .paint(painter, arrow);
}

} // namespace

void paintRow(QPainter* painter, const QRect& row, const QModelIndex& index, const RowLook& look)
{
    const States states = statesOf(index);
    const bool changed = states & (SettingsModel::Edited | SettingsModel::WrongText);
    QColor background = color(ColorRole::Panel);
    if (changed)
        background = color(ColorRole::Edit);
    else if (look.selected)
        background = color(ColorRole::AccentSoft);
    else if (rowOf(index).isHeading())
        background = color(ColorRole::Background);
    else if (look.hovered)
        background = color(ColorRole::Hover);
    painter->fillRect(row, background);
    painter->fillRect(QRect(row.left(), row.bottom(), row.width(), 1), color(ColorRole::Grid));
    if (changed) {
        const bool wrong = states.testFlag(SettingsModel::WrongText);
        painter->fillRect(QRect(row.left(), row.top(), barWidth, row.height()),
                          color(wrong ? ColorRole::Error : ColorRole::EditBar));
    }
}

void paintRowFrame(QPainter* painter, const QRect& row, const RowLook& look)
{
    if (!look.current && !look.selected)
        return;
    // A tinted row keeps its tint when it is selected, so the selection needs a line of its own.
    painter->setBrush(Qt::NoBrush);
    painter->setPen(color(look.current ? ColorRole::Accent : ColorRole::Line));
    painter->drawRect(row.adjusted(0, 0, -1, -1));
}

void paintCell(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index)
{
    painter->save();
    painter->setFont(fontOf(option, index));
    painter->setPen(color(textRole(index)));
    const QString text = index.data().toString();
    if (index.column() == SettingsModel::Menu) {
        paintMenuCell(painter, option, index);
    } else if (!buttonRect(option, index).isEmpty()) {
        paintButton(painter, option, index);
    } else {
        const QFontMetrics metrics(painter->font());
        QRect inside = option.rect.adjusted(padding, 0, -padding, 0);
        if (index.column() == SettingsModel::NewValue) {
            const auto [icon, role] = markOf(statesOf(index));
            if (!icon.isEmpty()) {
                const QRect mark(inside.left(), inside.center().y() - iconSize / 2 + 1, iconSize, iconSize);
                Theme::instance().icon(icon, role).paint(painter, mark);
                inside.setLeft(mark.right() + Theme::unit);
            }
        }
        if (isValueColumn(index.column()))
            inside.setRight(inside.right() - pointPadding(text, rowOf(index), metrics));
        const auto alignment = Qt::Alignment(index.data(Qt::TextAlignmentRole).toInt());
        paintText(painter, inside, alignment, metrics.elidedText(text, Qt::ElideRight, inside.width()));
    }
    painter->restore();
}

QRect buttonRect(const QStyleOptionViewItem& option, const QModelIndex& index)
{
    const QString text = index.data(SettingsModel::ButtonRole).toString();
    if (text.isEmpty())
        return {};
    const QRect room = option.rect.adjusted(Theme::unit, 2, -Theme::unit, -3);
    const int width = qMin(buttonWidth(option, text), room.width());
    return {room.right() + 1 - width, room.top(), width, room.height()};
}

int contentWidth(const QStyleOptionViewItem& option, const QModelIndex& index)
{
    const QFontMetrics metrics(fontOf(option, index));
    if (index.column() == SettingsModel::Menu)
        return menuNumberWidth(option) + hierarchyBarsSize().width() + padding;
    if (const QString button = index.data(SettingsModel::ButtonRole).toString(); !button.isEmpty())
        return buttonWidth(option, button) + 2 * Theme::unit;
    const QString text = index.data().toString();
    int width = metrics.horizontalAdvance(text) + 2 * padding;
    if (index.column() == SettingsModel::NewValue)
        width += iconSize + Theme::unit; // room for a mark, so that it does not push the figures
    if (isValueColumn(index.column()))
        width += pointPadding(text, rowOf(index), metrics);
    return width;
}

} // namespace lds::ui::row_painter

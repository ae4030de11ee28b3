#include "sensor_delegate.h"

#include "sensor_list_model.h"
#include "theme.h"

#include <QPainter>

namespace lds::ui {

namespace {

constexpr int padding = 8;
constexpr int iconSize = 16;

struct StateLook {
    const char* icon;
    ColorRole role;
};

StateLook lookOf(SensorListModel::State state)
{
    switch (state) {
    case SensorListModel::State::Good:
        return {"state-ok", ColorRole::Go};
    case SensorListModel::State::Warning:
        return {"state-warning", ColorRole::Warning};
    case SensorListModel::State::Busy:
        return {"state-busy", ColorRole::Accent};
    case SensorListModel::State::Offline:
        break;
    }
    return {"state-offline", ColorRole::Muted};
}

QFont smallFont(const QFont& font)
{
    QFont small = font;
    small.setPointSizeF(font.pointSizeF() * 0.87);
    return small;
}

QFont boldFont(const QFont& font)
{
    QFont bold = font;
    bold.setWeight(QFont::DemiBold);
    return bold;
}

void paintBackground(QPainter* painter, const QRect& place, QStyle::State state)
{
    const bool selected = state & QStyle::State_Selected;
    if (selected || (state & QStyle::State_MouseOver)) {
        painter->setPen(Qt::NoPen);
        painter->setBrush(color(selected ? ColorRole::AccentSoft : ColorRole::Hover));
        painter->drawRoundedRect(place, 4, 4);
    }
    if (state & QStyle::State_HasFocus) {
        painter->setPen(color(ColorRole::Accent));
        painter->setBrush(Qt::NoBrush);
        painter->drawRoundedRect(QRectF(place).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
}

/// How many edits wait for the sensor, in the colours of an edited row, at the right end of `line`.
/// Returns the width it took.
int paintBadge(QPainter* painter, const QRect& line, int edits, const QFont& font)
{
    if (edits == 0)
        return 0;
    const QString text = QString::number(edits);
    painter->setFont(font);
    const int width = painter->fontMetrics().horizontalAdvance(text) + 12;
    const QRectF badge(line.right() - width + 1, line.top() + 1, width, line.height() - 2);
    painter->setPen(color(ColorRole::EditBar));
    painter->setBrush(color(ColorRole::Edit));
    painter->drawRoundedRect(badge.adjusted(0.5, 0.5, -0.5, -0.5), badge.height() / 2, badge.height() / 2);
    painter->setPen(color(ColorRole::Warning));
    painter->drawText(badge, Qt::AlignCenter, text);
    return width + 4;
}

} // namespace

void SensorDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRect place = option.rect.adjusted(0, 0, 0, -4);
    paintBackground(painter, place, option.state);

    const auto look = lookOf(SensorListModel::State(index.data(SensorListModel::StateRole).toInt()));
    const QFontMetrics bold(boldFont(option.font));
    const QFontMetrics small(smallFont(option.font));
    QRect line = place.adjusted(padding + iconSize + 6, padding - 2, -padding, 0);
    line.setHeight(bold.height());
    Theme::instance()
        .icon(QLatin1StringView(look.icon), look.role)
        .paint(painter,
               QRect(place.left() + padding, line.center().y() - iconSize / 2 + 1, iconSize, iconSize));
    const int taken =
        paintBadge(painter, line, index.data(SensorListModel::EditsRole).toInt(), smallFont(option.font));

    painter->setFont(boldFont(option.font));
    painter->setPen(color(ColorRole::Text));
    painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                      bold.elidedText(index.data().toString(), Qt::ElideRight, line.width() - taken));
    painter->setFont(smallFont(option.font));
    painter->setPen(color(ColorRole::Muted));
    const QStringList texts{index.data(SensorListModel::DetailRole).toString(),
                            index.data(SensorListModel::UrlRole).toString()};
    for (const QString& text : texts) {
        line.translate(0, line.height() + 1);
        line.setHeight(small.height());
        painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                          small.elidedText(text, Qt::ElideRight, line.width()));
    }
    painter->restore();
}

QSize SensorDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const
{
    const int height = QFontMetrics(boldFont(option.font)).height() +
                       2 * (QFontMetrics(smallFont(option.font)).height() + 1) + 2 * padding;
    return {200, height};
}

} // namespace lds::ui

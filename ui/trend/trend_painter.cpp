#include "trend_painter.h"

#include "theme.h"
#include "trend_texts.h"

#include <cmath>
#include <QPainter>

namespace lds::ui {

namespace {

constexpr double narrowestHatch = 6;

/// Half a pixel off, so that a line one pixel wide is crisp.
double crisp(double pixel) { return std::floor(pixel) + 0.5; }

QColor faint(ColorRole role, int alpha)
{
    QColor result = color(role);
    result.setAlpha(alpha);
    return result;
}

double viewY(const TrendScene& scene, double value)
{
    return scene.layout.plot.bottom() - scene.scale.y(value);
}

bool isInside(const TrendScene& scene, double value)
{
    return value >= scene.scale.range.low && value <= scene.scale.range.high;
}

void paintBand(QPainter& painter, const TrendScene& scene)
{
    const TrendLimits& limits = scene.limits;
    if (!limits.high.held || !limits.low.held || *limits.high.held <= *limits.low.held)
        return;
    const QRectF plot = scene.layout.plot;
    const double top = std::clamp(viewY(scene, *limits.high.held), plot.top(), plot.bottom());
    const double bottom = std::clamp(viewY(scene, *limits.low.held), plot.top(), plot.bottom());
    painter.fillRect(QRectF(plot.left(), top, plot.width(), bottom - top), color(ColorRole::Band));
}

void paintFrozen(QPainter& painter, const TrendScene& scene)
{
    const QRectF plot = scene.layout.plot;
    for (const PixelRun& run : scene.frozen) {
        const double left = std::max(run.left, 0.0);
        const double right = std::min(run.right, plot.width());
        if (right <= left)
            continue;
        const QRectF stretch(plot.left() + left, plot.top(), right - left, plot.height());
        if (stretch.width() >= narrowestHatch) // narrower it would be a smear; the line's colour tells
            painter.fillRect(stretch, QBrush(faint(ColorRole::Warning, 70), Qt::BDiagPattern));
        const QString word = TrendTexts::tr("value frozen");
        if (painter.fontMetrics().horizontalAdvance(word) + 8 > stretch.width())
            continue;
        painter.setPen(color(ColorRole::Warning));
        painter.drawText(stretch.adjusted(0, 0, 0, -4), Qt::AlignHCenter | Qt::AlignBottom, word);
    }
}

/// A text on a patch of the ground's colour, so that the line behind does not run through it.
void paintLabel(QPainter& painter, const QRectF& box, const QString& text, const QColor& ink)
{
    QColor ground = color(ColorRole::Panel);
    ground.setAlpha(210);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(box, 3, 3);
    painter.setPen(ink);
    painter.drawText(box, Qt::AlignCenter, text);
}

enum class Side { Above, Below };

/// Where a limit's label stands: beside its line, or at the edge that the line lies behind.
struct LimitLabel {
    QString text;
    QRectF box;
};

LimitLabel labelOf(const QPainter& painter, const TrendScene& scene, catalog::Value value, QString text,
                   Side side, Qt::Alignment end)
{
    const QRectF plot = scene.layout.plot;
    const double height = painter.fontMetrics().height();
    double y = viewY(scene, value);
    if (!isInside(scene, value)) {
        const bool above = value > scene.scale.range.high;
        text += above ? QStringLiteral(" ▲") : QStringLiteral(" ▼");
        side = above ? Side::Below : Side::Above;
        y = above ? plot.top() : plot.bottom();
    }
    const double width = painter.fontMetrics().horizontalAdvance(text) + 8;
    const double top = std::clamp(side == Side::Above ? y - height - 2 : y + 2, plot.top() - height / 2,
                                  plot.bottom() - height);
    const double left = end == Qt::AlignRight ? plot.right() - width - 2 : plot.left() + 4;
    return {text, QRectF(left, top, width, height)};
}

void paintLimitLine(QPainter& painter, const TrendScene& scene, catalog::Value value, const QColor& ink,
                    double width, const QList<qreal>& dashes)
{
    if (!isInside(scene, value))
        return;
    QPen pen(ink, width);
    pen.setDashPattern(dashes);
    painter.setPen(pen);
    const QRectF plot = scene.layout.plot;
    const double y = crisp(viewY(scene, value));
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
}

QColor heldInk(const TrendScene& scene, ColorRole role)
{
    return scene.limits.stale ? color(ColorRole::Muted) : color(role);
}

void paintLimitLines(QPainter& painter, const TrendScene& scene, const TrendLimit& limit, ColorRole role)
{
    if (limit.held)
        paintLimitLine(painter, scene, *limit.held, heldInk(scene, role), 1.5, {4, 3});
    if (limit.wanted) // a pending edit: thinner and dotted
        paintLimitLine(painter, scene, *limit.wanted, color(ColorRole::EditBar), 1, {1, 3});
}

void paintLimitLabels(QPainter& painter, const TrendScene& scene, const TrendLimit& limit, ColorRole role,
                      Side side)
{
    if (limit.wanted) { // on the left, where the held limit's label is not, and off the held limit's line
        const Side away = !limit.held ? side : *limit.wanted >= *limit.held ? Side::Above : Side::Below;
        const LimitLabel label =
            labelOf(painter, scene, *limit.wanted, limit.wantedText, away, Qt::AlignLeft);
        paintLabel(painter, label.box, label.text, color(ColorRole::Warning));
    }
    if (!limit.held)
        return;
    const QFont plain = painter.font();
    QFont bold = plain;
    bold.setBold(true);
    painter.setFont(bold);
    const QString text =
        scene.limits.stale ? TrendTexts::tr("%1 (last known)").arg(limit.heldText) : limit.heldText;
    const LimitLabel label = labelOf(painter, scene, *limit.held, text, side, Qt::AlignRight);
    paintLabel(painter, label.box, label.text, heldInk(scene, role));
    painter.setFont(plain);
}

void paintLimits(QPainter& painter, const TrendScene& scene)
{
    paintLimitLines(painter, scene, scene.limits.high, ColorRole::High);
    paintLimitLines(painter, scene, scene.limits.low, ColorRole::Low);
    paintLimitLabels(painter, scene, scene.limits.high, ColorRole::High, Side::Above);
    paintLimitLabels(painter, scene, scene.limits.low, ColorRole::Low, Side::Below);
}

void paintValueAxis(QPainter& painter, const TrendScene& scene)
{
    const QRectF plot = scene.layout.plot;
    const double height = painter.fontMetrics().height();
    painter.setPen(color(ColorRole::Muted));
    for (const ValueTick& tick : scene.valueTicks) {
        const double y = viewY(scene, tick.value);
        painter.drawText(QRectF(0, y - height / 2, plot.left() - 8, height),
                         Qt::AlignRight | Qt::AlignVCenter, tick.text);
    }
    painter.drawText(QRectF(0, 2, plot.left() - 8, height), Qt::AlignRight | Qt::AlignVCenter,
                     QStringLiteral("mm"));
}

void paintTimeAxis(QPainter& painter, const TrendScene& scene)
{
    const QRectF plot = scene.layout.plot;
    painter.setPen(color(ColorRole::Muted));
    for (const TimeTick& tick : scene.timeTicks) {
        const double width = painter.fontMetrics().horizontalAdvance(tick.text) + 2;
        const double middle = plot.left() + scene.scale.x(tick.monotonicNs);
        const double left = std::clamp(middle - width / 2, plot.left() - 12, plot.right() + 16 - width);
        painter.drawText(QRectF(left, plot.bottom() + 8, width, painter.fontMetrics().height()),
                         Qt::AlignCenter, tick.text);
    }
}

void paintStates(QPainter& painter, const TrendScene& scene)
{
    struct Row {
        QString name;
        ColorRole role;
    };
    const std::array<Row, TrendLayout::stateRows> rows{{{QStringLiteral("HI"), ColorRole::High},
                                                        {QStringLiteral("GO"), ColorRole::Go},
                                                        {QStringLiteral("LO"), ColorRole::Low},
                                                        {TrendTexts::tr("Alarm"), ColorRole::Warning}}};
    for (int index = 0; index < TrendLayout::stateRows; ++index) {
        const QRectF row = scene.layout.stateRow(index);
        painter.setPen(color(ColorRole::Muted));
        painter.drawText(QRectF(0, row.top() - 2, row.left() - 8, row.height() + 4),
                         Qt::AlignRight | Qt::AlignVCenter, rows[std::size_t(index)].name);
        painter.fillRect(QRectF(row.left(), crisp(row.center().y()) - 0.5, row.width(), 1),
                         color(ColorRole::Grid));
        for (const PixelRun& run : scene.states[std::size_t(index)]) {
            const double left = std::clamp(run.left, 0.0, row.width());
            const double right = std::clamp(std::max(run.right, run.left + 1), 0.0, row.width());
            painter.fillRect(QRectF(row.left() + left, row.top() + 3, right - left, row.height() - 6),
                             color(rows[std::size_t(index)].role));
        }
    }
}

/// With a line in the plot a strip at its top; without one, the middle of the plot.
void paintNotice(QPainter& painter, const TrendScene& scene)
{
    if (scene.notice.isEmpty())
        return;
    const QRectF plot = scene.layout.plot;
    QFont bold = painter.font();
    const QFont plain = bold;
    bold.setBold(true);
    if (scene.hasData) {
        painter.setFont(bold);
        const QString text = QStringLiteral("▲ ") + scene.notice.title;
        const double titleWidth = painter.fontMetrics().horizontalAdvance(text);
        const double detailWidth = QFontMetricsF(plain).horizontalAdvance(scene.notice.detail) + 12;
        const double height = painter.fontMetrics().height() + 8;
        const double width = std::min(titleWidth + detailWidth + 24, plot.width());
        const QRectF box(plot.center().x() - width / 2, plot.top() + 4, width, height);
        painter.setPen(QPen(color(ColorRole::Warning), 1));
        painter.setBrush(color(ColorRole::Panel));
        painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        painter.setPen(color(ColorRole::Warning));
        painter.drawText(box.adjusted(12, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
        painter.setFont(plain);
        painter.setPen(color(ColorRole::Text));
        const QRectF rest = box.adjusted(12 + titleWidth + 12, 0, -8, 0);
        painter.drawText(
            rest, Qt::AlignLeft | Qt::AlignVCenter,
            painter.fontMetrics().elidedText(scene.notice.detail, Qt::ElideRight, int(rest.width()) + 1));
        return;
    }
    QFont large = bold;
    large.setPointSizeF(plain.pointSizeF() * 1.25);
    const double lineHeight = QFontMetricsF(large).height() + 6;
    const QRectF title(plot.left(), plot.center().y() - lineHeight, plot.width(), lineHeight);
    painter.setFont(large);
    painter.setPen(color(ColorRole::Text));
    painter.drawText(title, Qt::AlignCenter, scene.notice.title);
    painter.setFont(plain);
    painter.setPen(color(ColorRole::Muted));
    const double textWidth = std::min(plot.width(), 560.0);
    painter.drawText(
        QRectF(plot.center().x() - textWidth / 2, title.bottom(), textWidth, plot.bottom() - title.bottom()),
        Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, scene.notice.detail);
}

void paintPointer(QPainter& painter, const TrendScene& scene)
{
    if (!scene.pointer)
        return;
    const QRectF plot = scene.layout.plot;
    const auto readout = readoutAt(scene, scene.pointer->x() - plot.left());
    if (!readout)
        return;
    const double x = crisp(plot.left() + readout->x);
    painter.setPen(QPen(color(ColorRole::Muted), 1));
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, scene.layout.states.bottom()));
    QStringList lines{readout->time, readout->value};
    if (!readout->state.isEmpty())
        lines.append(readout->state);
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines)
        width = std::max(width, metrics.horizontalAdvance(line));
    QRectF box(0, 0, width + 16, metrics.height() * double(lines.size()) + 8);
    const bool toTheLeft = x + 12 + box.width() > plot.right();
    box.moveLeft(toTheLeft ? x - 12 - box.width() : x + 12);
    box.moveTop(std::clamp(scene.pointer->y() - box.height() - 8, plot.top(), plot.bottom() - box.height()));
    painter.setPen(QPen(color(ColorRole::Line), 1));
    painter.setBrush(color(ColorRole::Panel));
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    for (int index = 0; index < lines.size(); ++index) {
        painter.setPen(color(index == 1 ? ColorRole::Text : ColorRole::Muted));
        painter.drawText(
            QRectF(box.left() + 8, box.top() + 4 + index * metrics.height(), width + 1, metrics.height()),
            Qt::AlignLeft | Qt::AlignVCenter, lines[index]);
    }
}

} // namespace

void paintBelowLine(QPainter& painter, const TrendScene& scene)
{
    const QRectF plot = scene.layout.plot;
    if (!scene.hasData)
        return;
    paintBand(painter, scene);
    painter.setPen(QPen(color(ColorRole::Grid), 1));
    for (const ValueTick& tick : scene.valueTicks) {
        const double y = crisp(viewY(scene, tick.value));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    }
    for (const TimeTick& tick : scene.timeTicks) {
        const double x = crisp(plot.left() + scene.scale.x(tick.monotonicNs));
        painter.drawLine(QPointF(x, plot.bottom()), QPointF(x, plot.bottom() + 4));
    }
    paintFrozen(painter, scene);
}

void paintAboveLine(QPainter& painter, const TrendScene& scene)
{
    if (scene.hasData) {
        paintLimits(painter, scene);
        paintValueAxis(painter, scene);
        paintTimeAxis(painter, scene);
        paintStates(painter, scene);
    }
    paintNotice(painter, scene);
    paintPointer(painter, scene);
}

} // namespace lds::ui

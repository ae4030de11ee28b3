#include "readout_painter.h"

#include "theme.h"

#include <array>
#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

namespace lds::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(lds::ui::Readout)
};

constexpr int fullWidth = 940; ///< Pixels from which on nothing needs to move together.

/// Places of the parts, from left to right.
struct Layout {
    QRect chips, value, judgment, meter;
    int chipWidth;
    int valuePixels;
};

Layout layoutFor(const QRect& rect)
{
    const bool wide = rect.width() >= fullWidth;
    const int margin = wide ? 20 : 12;
    const int gap = wide ? 20 : 12;
    Layout layout;
    layout.chipWidth = wide ? 60 : 50;
    layout.valuePixels = wide ? 44 : 36;
    const int chips = 3 * layout.chipWidth + 2 * 6;
    const int judgment = wide ? 3 * 62 + 2 * 8 : 3 * 50 + 2 * 4;
    const int meter = wide ? 170 : qBound(96, rect.width() / 6, 150);
    QRect inside = rect.adjusted(margin, 0, -margin, 0);
    layout.chips = QRect(inside.left(), inside.top(), chips, inside.height());
    layout.meter = QRect(inside.right() - meter + 1, inside.top(), meter, inside.height());
    layout.judgment = QRect(layout.meter.left() - gap - judgment, inside.top(), judgment, inside.height());
    layout.value = QRect(QPoint(layout.chips.right() + gap, inside.top()),
                         QPoint(layout.judgment.left() - gap, inside.bottom()));
    return layout;
}

QFont smallFont(const QFont& font, bool bold)
{
    QFont small = font;
    small.setPointSizeF(font.pointSizeF() * 0.85);
    small.setWeight(bold ? QFont::DemiBold : QFont::Normal);
    return small;
}

void paintChip(QPainter* painter, const QRect& rect, const QString& text, bool lit, ColorRole litRole)
{
    const QColor frame = color(lit ? litRole : ColorRole::DisplayLine);
    painter->setPen(frame);
    painter->setBrush(lit ? QBrush(frame) : QBrush(Qt::NoBrush));
    painter->drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    painter->setPen(color(lit ? ColorRole::DisplayBackground : ColorRole::DisplayDim));
    painter->drawText(rect, Qt::AlignCenter, text);
}

void paintChips(QPainter* painter, const Layout& layout, const ReadoutState& state, const QFont& font)
{
    struct Chip {
        QString text;
        bool lit;
        ColorRole role = ColorRole::DisplayLit;
    };
    const bool hasMode = !state.holdModeLetter.isEmpty();
    // The device's own words (§2.2): not translated.
    const std::array<Chip, 6> chips{
        {{QStringLiteral("LASER"), state.laser, ColorRole::DisplayLaser},
         {QStringLiteral("HOLD"), state.hold},
         {QStringLiteral("ZERO"), state.zero},
         {state.bank > 0 ? QStringLiteral("B%1").arg(state.bank) : QStringLiteral("B\u2013"), state.bank > 0},
         {hasMode ? state.holdModeLetter : QStringLiteral("P B PP"), hasMode},
         {QStringLiteral("KEYLOCK"), state.keyLock, ColorRole::DisplayWarning}}};
    QFont chipFont = smallFont(font, true);
    while (QFontMetrics(chipFont).horizontalAdvance(QStringLiteral("KEYLOCK")) > layout.chipWidth - 2 &&
           chipFont.pointSizeF() > 5)
        chipFont.setPointSizeF(chipFont.pointSizeF() - 0.25);
    painter->setFont(chipFont);
    constexpr int height = 22;
    constexpr int gap = 6;
    const int top = layout.chips.center().y() - height - gap / 2;
    for (int index = 0; index < int(chips.size()); ++index) {
        const Chip& chip = chips[std::size_t(index)];
        const QRect place(layout.chips.left() + index % 3 * (layout.chipWidth + gap),
                          top + index / 3 * (height + gap), layout.chipWidth, height);
        paintChip(painter, place, chip.text, chip.lit, chip.role);
    }
}

/// The line under the value: what is the matter, else how the stream goes.
void paintNotice(QPainter* painter, const QRect& place, const ReadoutState& state, const QFont& font)
{
    const bool warns = !state.notice.isEmpty();
    const QString text = warns ? state.notice : state.pace;
    if (text.isEmpty())
        return;
    painter->setFont(smallFont(font, warns));
    const QColor ink = color(warns ? ColorRole::DisplayWarning : ColorRole::DisplayMuted);
    painter->setPen(ink);
    constexpr int icon = 13;
    const int room = place.width() - (warns ? icon + 4 : 0);
    const QString shown = painter->fontMetrics().elidedText(text, Qt::ElideRight, room);
    painter->drawText(place, Qt::AlignRight | Qt::AlignVCenter, shown);
    if (warns) {
        const int left = place.right() - painter->fontMetrics().horizontalAdvance(shown) - icon - 4;
        Theme::instance()
            .icon(QStringLiteral("state-warning"), ColorRole::DisplayWarning)
            .paint(painter, QRect(left, place.center().y() - icon / 2, icon, icon));
    }
}

void paintValue(QPainter* painter, const Layout& layout, const ReadoutState& state, const QFont& font)
{
    constexpr int noticeHeight = 20;
    QRect number = layout.value.adjusted(0, 6, 0, -noticeHeight - 6);
    const QRect notice(layout.value.left(), layout.value.bottom() - noticeHeight - 6, layout.value.width(),
                       noticeHeight);
    paintNotice(painter, notice, state, font);
    if (state.value.isEmpty())
        return;

    const bool doubtful = !state.isLive || state.isFrozen;
    painter->setFont(smallFont(font, false));
    const int unitWidth = painter->fontMetrics().horizontalAdvance(QStringLiteral("mm")) + 8;
    QFont display = Theme::instance().displayFont(layout.valuePixels);
    while (QFontMetrics(display).horizontalAdvance(state.value) > number.width() - unitWidth &&
           display.pixelSize() > 16)
        display.setPixelSize(display.pixelSize() - 2);
    const QFontMetrics metrics(display);
    const int baseline = number.center().y() + metrics.capHeight() / 2 + 1;
    const int right = number.right() - unitWidth;
    painter->setPen(color(doubtful ? ColorRole::DisplayDim : ColorRole::Display));
    if (state.isNumber)
        painter->drawText(right + 8, baseline, QStringLiteral("mm"));
    painter->setFont(display);
    const int width = metrics.horizontalAdvance(state.value);
    painter->drawText(right - width, baseline, state.value);
    if (state.isFrozen) { // told from a measurement by shape, not by its grey alone
        painter->setPen(QPen(color(ColorRole::DisplayWarning), 2, Qt::DotLine));
        painter->drawLine(right - width, baseline + 6, right, baseline + 6);
    }
}

/// ▲, ●, ▼: drawn, since fonts differ in what they make of the characters.
void paintMark(QPainter* painter, const QRectF& box, Judgment judgment, const QColor& ink)
{
    painter->setPen(Qt::NoPen);
    painter->setBrush(ink);
    if (judgment == Judgment::Go) {
        painter->drawEllipse(box);
        return;
    }
    const bool up = judgment == Judgment::High;
    QPainterPath triangle;
    triangle.moveTo(box.left(), up ? box.bottom() : box.top());
    triangle.lineTo(box.right(), up ? box.bottom() : box.top());
    triangle.lineTo(box.center().x(), up ? box.top() : box.bottom());
    triangle.closeSubpath();
    painter->drawPath(triangle);
}

void paintJudgments(QPainter* painter, const Layout& layout, const ReadoutState& state, const QFont& font)
{
    struct Box {
        Judgment judgment;
        QString text;
        ColorRole role;
    };
    const std::array<Box, 3> boxes{{{Judgment::High, QStringLiteral("HI"), ColorRole::DisplayHigh},
                                    {Judgment::Go, QStringLiteral("GO"), ColorRole::DisplayGo},
                                    {Judgment::Low, QStringLiteral("LO"), ColorRole::DisplayLow}}};
    QFont bold = font;
    bold.setWeight(QFont::DemiBold);
    painter->setFont(bold);
    const QFontMetrics metrics(bold);
    const int gap = layout.chipWidth > 50 ? 8 : 4;
    const int width = (layout.judgment.width() - 2 * gap) / 3;
    constexpr int height = 48;
    int left = layout.judgment.left();
    for (const Box& box : boxes) {
        const bool lit = state.judgment == box.judgment;
        const QRectF place(left, layout.judgment.center().y() - height / 2, width, height);
        const QColor frame = color(lit ? box.role : ColorRole::DisplayLine);
        painter->setPen(frame);
        painter->setBrush(lit ? QBrush(frame) : QBrush(Qt::NoBrush));
        painter->drawRoundedRect(place.adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        const QColor ink = color(lit ? ColorRole::DisplayGoText : ColorRole::DisplayDim);
        constexpr qreal mark = 9;
        const qreal textWidth = metrics.horizontalAdvance(box.text);
        const qreal start = place.center().x() - (mark + 5 + textWidth) / 2;
        paintMark(painter, QRectF(start, place.center().y() - mark / 2, mark, mark), box.judgment, ink);
        painter->setPen(ink);
        painter->drawText(QRectF(start + mark + 5, place.top(), textWidth + 2, place.height()),
                          Qt::AlignLeft | Qt::AlignVCenter, box.text);
        left += width + gap;
    }
}

void paintMeter(QPainter* painter, const Layout& layout, const ReadoutState& state, const QFont& font)
{
    constexpr int most = 1023;
    painter->setFont(smallFont(font, false));
    const int line = painter->fontMetrics().height() + 2;
    const int top = layout.meter.center().y() - (2 * line + 14) / 2;
    painter->setPen(color(ColorRole::DisplayMuted));
    const QRect label(layout.meter.left(), top, layout.meter.width(), line);
    painter->drawText(
        label, Qt::AlignLeft | Qt::AlignVCenter,
        painter->fontMetrics().elidedText(Words::tr("Received light"), Qt::ElideRight, label.width()));
    const QRectF track(layout.meter.left(), top + line + 4, layout.meter.width(), 6);
    painter->setPen(Qt::NoPen);
    painter->setBrush(color(ColorRole::DisplayLine));
    painter->drawRoundedRect(track, 3, 3);
    if (state.intensity && *state.intensity > 0) {
        QRectF bar = track;
        bar.setWidth(qMax(6.0, track.width() * *state.intensity / most));
        painter->setBrush(color(ColorRole::DisplayMeter));
        painter->drawRoundedRect(bar, 3, 3);
    }
    painter->setPen(color(ColorRole::DisplayMuted));
    const QString text =
        state.intensity ? Words::tr("%1 of %2").arg(*state.intensity).arg(most) : QStringLiteral("----");
    painter->drawText(QRect(layout.meter.left(), int(track.bottom()) + 4, layout.meter.width(), line),
                      Qt::AlignLeft | Qt::AlignVCenter, text);
}

} // namespace

void paintReadout(QPainter* painter, const QRect& rect, const ReadoutState& state, const QFont& font)
{
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    painter->setBrush(color(ColorRole::DisplayBackground));
    painter->drawRoundedRect(rect, 6, 6);
    const Layout layout = layoutFor(rect);
    paintChips(painter, layout, state, font);
    paintValue(painter, layout, state, font);
    paintJudgments(painter, layout, state, font);
    paintMeter(painter, layout, state, font);
}

} // namespace lds::ui

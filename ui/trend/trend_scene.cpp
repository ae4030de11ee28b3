#include "trend_scene.h"

#include "trend_texts.h"
#include "value_text.h"

#include <QFontMetrics>
#include <QStringList>

namespace lds::ui {

namespace {

constexpr int rowHeight = 14;
// A pointer this near to a sample means that sample, where samples are further apart than pixels.
constexpr int reach = 6;

QString stateWords(const measurement::TrendColumn& column)
{
    QStringList words;
    if (column.stateOr & measurement::HighBit)
        words += QStringLiteral("HI");
    if (column.stateOr & measurement::GoBit)
        words += QStringLiteral("GO");
    if (column.stateOr & measurement::LowBit)
        words += QStringLiteral("LO");
    if (column.stateOr & measurement::AlarmBit)
        words += column.hasFrozen ? TrendTexts::tr("alarm, value frozen") : TrendTexts::tr("alarm");
    else if (column.stateOr & measurement::IndeterminateBit)
        words += TrendTexts::tr("indeterminate");
    return words.join(QStringLiteral(", "));
}

} // namespace

TrendLayout TrendLayout::of(const QSizeF& size, const QFontMetrics& metrics)
{
    const double left = metrics.horizontalAdvance(QStringLiteral("−000.0000")) + 16;
    const double right = 20;
    const double top = 24;
    const double timeLabels = metrics.height() + 16;
    const double strip = stateRows * rowHeight;
    const double bottom = timeLabels + strip + 10;
    TrendLayout layout;
    layout.plot = QRectF(left, top, std::max(1.0, size.width() - left - right),
                         std::max(1.0, size.height() - top - bottom));
    layout.states = QRectF(left, layout.plot.bottom() + timeLabels, layout.plot.width(), strip);
    return layout;
}

QRectF TrendLayout::stateRow(int row) const
{
    return {states.left(), states.top() + row * rowHeight, states.width(), rowHeight};
}

std::optional<TrendReadout> readoutAt(const TrendScene& scene, double plotX)
{
    if (!scene.hasData)
        return std::nullopt;
    const qint64 pointedNs = scene.scale.timeAt(plotX);
    const auto index = columnNear(scene.columns, pointedNs, reach);
    TrendReadout readout;
    const qint64 ns = index ? scene.columns.middleNs(*index) : pointedNs;
    readout.x = index ? scene.scale.x(ns) : plotX;
    const qint64 resolution = scene.columns.columnNs >= 1'000'000'000 ? 1'000'000'000 : 1'000'000;
    readout.time = clockText(ns + scene.wallOffsetNs, resolution);
    if (!index) {
        readout.value = TrendTexts::tr("not measured");
        return readout;
    }
    const measurement::TrendColumn& column = scene.columns.columns[*index];
    const auto text = [&](catalog::Value value) {
        return settings::lengthText(value, scene.decimals, settings::TextStyle::Typographic);
    };
    if (!column.hasValue)
        readout.value = TrendTexts::tr("no value");
    else if (text(column.minimum) == text(column.maximum))
        readout.value = QStringLiteral("%1 mm").arg(text(column.minimum));
    else
        readout.value = QStringLiteral("%1 … %2 mm").arg(text(column.minimum), text(column.maximum));
    readout.state = stateWords(column);
    return readout;
}

} // namespace lds::ui

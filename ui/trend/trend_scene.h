#pragma once

#include "trend_line.h"
#include "trend_ticks.h"

#include <array>
#include <optional>
#include <QPointF>
#include <QRectF>
#include <QString>

class QFontMetrics;

namespace lds::ui {

/// HIGH or LOW: what the sensor holds and what a person wants it to be.
struct TrendLimit {
    std::optional<catalog::Value> held;   ///< 0.1 µm; nothing until read.
    std::optional<catalog::Value> wanted; ///< A pending edit.
    QString heldText;                     ///< "HIGH +1.7500"
    QString wantedText;
    friend bool operator==(const TrendLimit&, const TrendLimit&) = default;
};

struct TrendLimits {
    TrendLimit high;
    TrendLimit low;
    bool stale = false;     ///< Last known, not necessarily what the sensor holds.
    bool sayLittle = false; ///< The window is as wide as from the factory: nobody has set it yet.
    friend bool operator==(const TrendLimits&, const TrendLimits&) = default;
};

/// What the plot says in words.
struct TrendNotice {
    QString title;  ///< What is the matter: "Not connected".
    QString detail; ///< What to do, or what it means for the line.
    bool isEmpty() const { return title.isEmpty(); }
    friend bool operator==(const TrendNotice&, const TrendNotice&) = default;
};

/// Where the parts of a trend lie, in pixels of the view.
struct TrendLayout {
    QRectF plot;
    QRectF states; ///< The strip below: one row for each of HI, GO, LO, Alarm.
    static constexpr int stateRows = 4;
    static TrendLayout of(const QSizeF& size, const QFontMetrics& metrics);
    QRectF stateRow(int row) const;
};

/// Everything one frame is painted from, ready and in pixels.
struct TrendScene {
    TrendLayout layout;
    PlotScale scale;
    bool hasData = false;
    TrendColumns columns;
    QList<ValueTick> valueTicks;
    QList<TimeTick> timeTicks;
    std::array<QList<PixelRun>, TrendLayout::stateRows> states;
    QList<PixelRun> frozen; ///< Where values are held under an alarm.
    TrendLimits limits;
    TrendNotice notice;
    std::optional<QPointF> pointer; ///< In the view's pixels, inside the plot.
    qint64 wallOffsetNs = 0;
    int decimals = 4; ///< Of a length in mm.
};

/// What lies under the pointer: time, smallest … largest value, states.
struct TrendReadout {
    double x = 0; ///< Of the column it speaks of, in the plot's pixels.
    QString time;
    QString value;
    QString state;
};
std::optional<TrendReadout> readoutAt(const TrendScene& scene, double plotX);

} // namespace lds::ui

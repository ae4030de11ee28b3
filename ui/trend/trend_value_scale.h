#pragma once

#include "measurement.h"

#include <optional>
#include <QList>
#include <QtGlobal>

namespace lds::ui {

/// The value axis of a trend, in 0.1 µm: fitted to what is seen, or set by hand. A plain value, one for
/// each sensor.
///
/// Fitting widens at once, so that nothing is ever cut off, and narrows only after two seconds, so that
/// the axis does not pump with every workpiece. HIGH and LOW are fitted in while the values are about
/// them, so that a steady value stands quietly in its window; from far off, or with a window so wide that
/// it says little, only where that does not flatten the line. The painter then names them at the edge.
class TrendValueScale {
public:
    struct Range {
        double low = 0;
        double high = 0;
        double span() const { return high - low; }
        friend bool operator==(const Range&, const Range&) = default;
    };

    static constexpr qint64 narrowingDelayNs = 2'000'000'000;
    static constexpr double smallestSpan = 20;        ///< 2 µm
    static constexpr double largestSpan = 40'000'000; ///< ±2 m: beyond every sensor's display.

    const Range& range() const { return m_range; }
    bool isAutomatic() const { return m_automatic; }

    struct Limits {
        QList<catalog::Value> values;
        bool sayLittle = false; ///< As far apart as from the factory.
    };

    /// Does nothing when set by hand. `data`: what is seen now, nothing when no value is.
    void fit(std::optional<Range> data, const Limits& limits, qint64 nowNs);
    /// When the next fit() of the same data will narrow the axis; nothing when it will not.
    std::optional<qint64> narrowsAtNs() const { return m_narrowsAtNs; }

    void setAutomatic();                       ///< The next fit() fits exactly, narrowing at once.
    void zoomBy(double factor, double anchor); ///< By hand: `factor` times the span, `anchor` stays.
    void panBy(double difference);             ///< By hand.
    void setRange(const Range& range);         ///< By hand.

private:
    Range wanted(std::optional<Range> data, const Limits& limits);
    bool shouldFitLimits(const Range& data, const Range& limits, bool sayLittle) const;

    Range m_range{-10'000, 10'000};
    bool m_automatic = true;
    bool m_exact = true; ///< The next fit takes what it finds.
    bool m_limitsFitted = false;
    std::optional<qint64> m_narrowsAtNs;
};

} // namespace lds::ui

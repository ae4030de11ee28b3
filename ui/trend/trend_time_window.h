#pragma once

#include <QtGlobal>

namespace lds::ui {

/// A stretch of monotonic time, [fromNs, toNs).
struct TrendSpan {
    qint64 fromNs = 0;
    qint64 toNs = 0;
    qint64 lengthNs() const { return toNs - fromNs; }
    friend bool operator==(const TrendSpan&, const TrendSpan&) = default;
};

/// Which stretch of time a trend shows, and how gestures change it. A plain value, one for each sensor,
/// so that switching sensors keeps each one's view. `data` is always what is stored now: first and last
/// sample.
///
/// Following keeps the newest sample at the right edge. Paused freezes what is shown, whatever arrives,
/// and remembers whether it was following. Moving by hand leaves Follow.
class TrendTimeWindow {
public:
    static constexpr qint64 shortestNs = 10'000'000;                      ///< 10 ms
    static constexpr qint64 longestNs = 30LL * 24 * 3600 * 1'000'000'000; ///< 30 days
    static constexpr qint64 shortestAllNs = 1'000'000'000; ///< "All" of nearly nothing still has a time axis.

    TrendSpan span(const TrendSpan& data) const;

    bool isFollowing() const { return m_following; }
    bool isPaused() const { return m_paused; }
    bool showsAll() const { return m_all; }
    qint64 lengthNs() const { return m_lengthNs; } ///< Of the choice; meaningless while showsAll().

    void follow();                       ///< Jumps to the newest sample and stays there; ends Pause.
    void showAll(const TrendSpan& data); ///< Everything stored, growing with it.
    void setLength(qint64 lengthNs, const TrendSpan& data); ///< Keeps the right edge.
    void setPaused(bool paused, const TrendSpan& data);

    void panBy(qint64 ns, const TrendSpan& data); ///< Positive: towards newer samples.
    void panTo(const TrendSpan& span, const TrendSpan& data);
    /// Shows `factor` times as much time; the instant at `fraction` (0 left … 1 right) stays in place.
    /// With the right edge as anchor a following window goes on following.
    void zoomBy(double factor, double fraction, const TrendSpan& data);

private:
    void place(TrendSpan span, const TrendSpan& data);

    bool m_following = true;
    bool m_paused = false;
    bool m_all = false;
    qint64 m_lengthNs = 10'000'000'000;
    qint64 m_toNs = 0;  ///< Right edge while not following.
    TrendSpan m_frozen; ///< What is shown while paused.
};

} // namespace lds::ui

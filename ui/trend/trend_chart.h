#pragma once

#include "trend_scene.h"
#include "trend_series.h"
#include "trend_view.h"

#include <QChartView>

namespace lds::ui {

/// The plot of a trend: the line of one store, seen through one view, and every gesture on it. It draws
/// only what updateFrame() has prepared; whoever owns it decides when that is.
///
/// Mouse: wheel zooms time around the pointer, with Ctrl (or over the value axis) values, with Shift or
/// sideways pans; dragging pans, dragging the value axis zooms values; double-click follows and fits.
/// Keys: ← → pan, Page Up/Down by a whole window, Home to the oldest, End follows, ↑ ↓ move values,
/// + − zoom time, with Ctrl values, F fits, Space pauses.
class TrendChart final : public QChartView {
    Q_OBJECT

public:
    explicit TrendChart(QWidget* parent = nullptr);

    /// Both must live until replaced; nullptr for none.
    void setSource(const measurement::TrendStore* store, TrendView* view);
    void setLimits(const TrendLimits& limits);
    void setNotice(const TrendNotice& notice);
    void setDecimals(int decimals);

    void updateFrame(qint64 nowNs); ///< Reads the store and prepares what the next repaint shows.
    /// Samples newer than what the last frame showed would be seen.
    bool wantsFrame() const;
    const TrendScene& scene() const { return m_scene; }
    const TrendSeries& series() const { return m_series; }

    void follow(); ///< And fits the values.
    void fit();    ///< All that is stored, all values.
    void setPaused(bool paused);
    void setWindowLength(qint64 ns);                         ///< 0: all.
    bool pressKey(int key, Qt::KeyboardModifiers modifiers); ///< What the key means here; false: nothing.

Q_SIGNALS:
    void viewChanged();  ///< A gesture or a call changed the view: a frame is due.
    void pointerMoved(); ///< A repaint is due, nothing else.

protected:
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void resizeEvent(QResizeEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    enum class Drag { None, Pan, ValueAxis };
    struct DragStart {
        QPointF position;
        TrendSpan span;
        TrendValueScale::Range range;
        bool moved = false; ///< Beyond a click's tremble.
    };

    TrendSpan data() const;
    void layOut();
    void applyColors();
    void prepareTicks();
    void updateWallOffset(const TrendSpan& span);
    void setPointer(std::optional<QPointF> pointer);
    double plotX(double x) const { return x - m_scene.layout.plot.left(); }
    double valueAt(double y) const;
    void dragTo(const QPointF& position);

    TrendSeries m_series;
    const measurement::TrendStore* m_store = nullptr;
    TrendView* m_view = nullptr;
    TrendScene m_scene;
    qint64 m_shownNs = -1; ///< The newest sample the last frame saw.
    Drag m_drag = Drag::None;
    DragStart m_dragStart;
};

} // namespace lds::ui

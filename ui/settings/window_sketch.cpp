#include "window_sketch.h"

#include "item_text.h"
#include "row_facts.h"
#include "theme.h"

#include <algorithm>
#include <QPainter>
#include <QPainterPath>

namespace lds::ui {

using catalog::ItemId;
using sensor::SensorSession;

namespace {

constexpr qint64 tracedNs = 10'000'000'000; ///< 10 s
constexpr int labelHeight = 18;
constexpr int liveWidth = 6;

QString lengthOf(const SensorSession& session, ItemId id, qint64 value)
{
    return displayValue(session.catalog().item(id), session.model(), catalog::Value(value));
}

} // namespace

/// Maps lengths to rows of pixels. The window fills the middle, with a third of it above and below.
struct WindowSketch::Scale {
    QRectF area;
    qint64 high = 0;
    qint64 low = 0;
    qint64 hysteresis = 0;

    qreal margin() const { return area.height() / 4; }
    qreal place(qint64 value) const ///< May lie outside the area.
    {
        const qint64 top = std::max(high, low);
        const qint64 bottom = std::min(high, low);
        const qreal unit = (area.height() - 2 * margin()) / qreal(std::max<qint64>(top - bottom, 1));
        return area.top() + margin() + qreal(top - value) * unit;
    }
    bool shows(qint64 value) const { return place(value) >= area.top() && place(value) <= area.bottom(); }
    qreal y(qint64 value) const { return std::clamp(place(value), area.top(), area.bottom()); }
};

WindowSketch::WindowSketch(QWidget* parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

QSize WindowSketch::sizeHint() const { return {240, 120}; }

void WindowSketch::setSession(SensorSession* session)
{
    if (m_session)
        disconnect(m_session, nullptr, this, nullptr);
    m_session = session;
    if (session) {
        // Painted at most once a frame, however fast the batches come, and only while it is in sight.
        connect(session, &SensorSession::measured, this, qOverload<>(&QWidget::update));
        connect(session, &SensorSession::heldChanged, this, qOverload<>(&QWidget::update));
        connect(session, &SensorSession::pendingChanged, this, qOverload<>(&QWidget::update));
        connect(session, &SensorSession::connectionChanged, this, qOverload<>(&QWidget::update));
    }
    update();
}

void WindowSketch::paintEvent(QPaintEvent*)
{
    if (!m_session)
        return;
    const settings::Values values = RowFacts::wantedValues(*m_session);
    if (!values.contains(ItemId::HighSetValue) || !values.contains(ItemId::LowSetValue))
        return;
    Scale scale;
    scale.area = QRectF(rect());
    scale.high = values.value(ItemId::HighSetValue);
    scale.low = values.value(ItemId::LowSetValue);
    scale.hysteresis = values.value(ItemId::Hysteresis);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintWindow(painter, scale);
    paintHeld(painter, scale);
    paintTrace(painter, scale);
    setAccessibleName(spokenText(scale.high, scale.low));
}

void WindowSketch::paintWindow(QPainter& painter, const Scale& scale) const
{
    const qreal high = scale.y(scale.high);
    const qreal low = scale.y(scale.low);
    const QRectF& area = scale.area;
    if (scale.high > scale.low) {
        painter.fillRect(QRectF(area.left(), high, area.width(), low - high), color(ColorRole::Band));
        // Where the judgment comes back to GO (§4.4.3).
        for (const auto& [line, role] : {std::pair(scale.high - scale.hysteresis, ColorRole::High),
                                         std::pair(scale.low + scale.hysteresis, ColorRole::Low)}) {
            painter.setPen(QPen(color(role), 1, Qt::DotLine));
            if (scale.hysteresis > 0)
                painter.drawLine(QPointF(area.left(), scale.y(line)), QPointF(area.right(), scale.y(line)));
        }
    }
    painter.setPen(QPen(color(ColorRole::High), 1.5));
    painter.drawLine(QPointF(area.left(), high), QPointF(area.right(), high));
    const QRectF above(area.left() + 4, high - labelHeight, area.width() - 8, labelHeight);
    const QRectF below(area.left() + 4, low + 1, area.width() - 8, labelHeight);
    const bool upsideDown = scale.high <= scale.low; // the labels keep out of each other's way
    painter.drawText(upsideDown ? above.translated(0, labelHeight) : above, Qt::AlignLeft | Qt::AlignVCenter,
                     tr("HIGH %1").arg(lengthOf(*m_session, ItemId::HighSetValue, scale.high)));
    painter.setPen(QPen(color(ColorRole::Low), 1.5));
    painter.drawLine(QPointF(area.left(), low), QPointF(area.right(), low));
    painter.drawText(upsideDown ? below.translated(0, -labelHeight) : below, Qt::AlignLeft | Qt::AlignVCenter,
                     tr("LOW %1").arg(lengthOf(*m_session, ItemId::LowSetValue, scale.low)));
}

void WindowSketch::paintHeld(QPainter& painter, const Scale& scale) const
{
    for (const ItemId id : {ItemId::HighSetValue, ItemId::LowSetValue}) {
        const auto held = m_session->held(id);
        if (!held || !m_session->pending().find(id))
            continue;
        const QString text = tr("now %1").arg(lengthOf(*m_session, id, *held));
        const bool high = id == ItemId::HighSetValue;
        const qreal y = high ? scale.y(scale.high) - labelHeight : scale.y(scale.low) + 1;
        const QRectF label(scale.area.left() + 4, y, scale.area.width() - 8, labelHeight);
        painter.setPen(QPen(color(ColorRole::Muted), 1, Qt::DashLine));
        // Too far away for the picture: an arrow says where.
        if (scale.shows(*held))
            painter.drawLine(QPointF(scale.area.left(), scale.y(*held)),
                             QPointF(scale.area.right(), scale.y(*held)));
        const QString arrow = scale.shows(*held)                        ? QString()
                              : *held > std::max(scale.high, scale.low) ? QStringLiteral("↑ ")
                                                                        : QStringLiteral("↓ ");
        painter.drawText(label, Qt::AlignRight | Qt::AlignVCenter, arrow + text);
    }
}

void WindowSketch::paintTrace(QPainter& painter, const Scale& scale) const
{
    const auto& trend = m_session->trend();
    const auto& latest = m_session->latest();
    if (trend.isEmpty() || !latest)
        return; // nothing live to show
    const int count = std::max(1, int(scale.area.width()) - liveWidth);
    const auto columns = trend.columns(trend.lastNs() - tracedNs, trend.lastNs() + 1, count);
    QPainterPath line;
    bool joined = false;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto& column = columns.at(i);
        if (!column.hasValue)
            continue;
        const qreal x = scale.area.left() + qreal(i);
        if (!joined || column.gapBefore)
            line.moveTo(x, scale.place(column.first));
        for (const auto value : {column.first, column.minimum, column.maximum, column.last})
            line.lineTo(x, scale.place(value));
        joined = true;
    }
    painter.save();
    painter.setClipRect(scale.area);
    painter.setPen(QPen(color(ColorRole::Series), 1.5));
    painter.drawPath(line);
    painter.restore();
    if (latest->hasValue())
        paintLatest(painter, scale, latest->value);
}

void WindowSketch::paintLatest(QPainter& painter, const Scale& scale, catalog::Value value) const
{
    const QPointF at(scale.area.right() - liveWidth, scale.y(value));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color(ColorRole::Series));
    if (scale.shows(value)) {
        painter.drawEllipse(at, 2.5, 2.5);
        return;
    }
    const qreal way = value > std::max(scale.high, scale.low) ? -1 : 1; // beyond the picture, up or down
    painter.drawPolygon(QPolygonF{at + QPointF(0, way * 6), at + QPointF(-4, 0), at + QPointF(4, 0)});
}

QString WindowSketch::spokenText(qint64 high, qint64 low) const
{
    return tr("Judgment window from LOW %1 to HIGH %2")
        .arg(lengthOf(*m_session, ItemId::LowSetValue, low),
             lengthOf(*m_session, ItemId::HighSetValue, high));
}

} // namespace lds::ui

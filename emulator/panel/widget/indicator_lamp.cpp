#include "indicator_lamp.h"

#include <QFontMetrics>
#include <QPainter>

namespace lds::emulator {

namespace {

constexpr int blinkMs = 400;
constexpr int lampSize = 10;
constexpr int gap = 6;
const QColor darkLamp(0x3a, 0x40, 0x49);
const QColor nameColor(0xc8, 0xd0, 0xda);

} // namespace

IndicatorLamp::IndicatorLamp(const QString& name, const QColor& color, QWidget* parent)
    : QWidget(parent)
    , m_name(name)
    , m_color(color)
{
    m_blink.setInterval(blinkMs);
    connect(&m_blink, &QTimer::timeout, this, [this] {
        m_bright = !m_bright;
        update();
    });
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    setAccessibleName(tr("%1 indicator").arg(name));
    setAccessibleDescription(tr("off"));
}

void IndicatorLamp::showState(IndicatorState state)
{
    if (state == m_state)
        return;
    m_state = state;
    m_bright = state != IndicatorState::Off;
    if (state == IndicatorState::Blinking)
        m_blink.start();
    else
        m_blink.stop();
    setAccessibleDescription(state == IndicatorState::Off   ? tr("off")
                             : state == IndicatorState::Lit ? tr("lit")
                                                            : tr("blinking"));
    update();
}

QSize IndicatorLamp::sizeHint() const
{
    const QFontMetrics metrics(font());
    return {lampSize + gap + metrics.horizontalAdvance(m_name) + 2, std::max(lampSize + 2, metrics.height())};
}

void IndicatorLamp::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF lamp(1, (height() - lampSize) / 2.0, lampSize, lampSize);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_bright ? m_color : darkLamp);
    painter.drawEllipse(lamp);
    painter.setPen(nameColor);
    painter.drawText(QRectF(lampSize + gap, 0, width() - lampSize - gap, height()),
                     Qt::AlignLeft | Qt::AlignVCenter, m_name);
}

} // namespace lds::emulator

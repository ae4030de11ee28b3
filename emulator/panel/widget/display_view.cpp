#include "display_view.h"

#include "display_painter.h"

#include <QPainter>

namespace lds::emulator {

DisplayView::DisplayView(QWidget* parent)
    : QWidget(parent)
{
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setObjectName(QStringLiteral("sensorDisplay"));
    setAccessibleName(tr("Sensor display"));
}

void DisplayView::showContent(const DisplayContent& content)
{
    if (content == m_content)
        return;
    m_content = content;
    setAccessibleDescription(spokenDisplay(content));
    update();
}

int DisplayView::heightForWidth(int width) const { return int(width / displayAspect); }

void DisplayView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    QSizeF size(displayAspect, 1);
    size.scale(this->size(), Qt::KeepAspectRatio);
    QRectF area(QPointF(), size);
    area.moveCenter(QRectF(rect()).center());
    paintDisplay(painter, area, m_content);
}

} // namespace lds::emulator

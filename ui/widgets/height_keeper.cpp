#include "height_keeper.h"

#include <QEvent>
#include <QLayout>
#include <QWidget>

namespace lds::ui {

HeightKeeper::HeightKeeper(QWidget* window)
    : QObject(window)
    , m_window(window)
{
    window->installEventFilter(this);
}

bool HeightKeeper::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::LayoutRequest:
    case QEvent::Resize:
    case QEvent::Show:
        keep();
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void HeightKeeper::keep()
{
    QLayout* layout = m_window->layout();
    if (!layout || !layout->hasHeightForWidth())
        return;
    const int needed = layout->totalHeightForWidth(m_window->width());
    if (m_window->minimumHeight() != needed)
        m_window->setMinimumHeight(needed);
}

} // namespace lds::ui

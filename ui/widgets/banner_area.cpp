#include "banner_area.h"

#include <QVBoxLayout>

namespace lds::ui {

BannerArea::BannerArea(QWidget* parent)
    : QWidget(parent)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    setVisible(false);
}

void BannerArea::showMessage(const QString& subject, const Message& message)
{
    Banner* banner = find(subject);
    if (!banner) {
        banner = new Banner(this);
        banner->setObjectName(QStringLiteral("banner.") + subject);
        m_banners.insert(subject, banner);
        connect(banner, &Banner::closed, this, [this, subject] { hideMessage(subject); });
        connect(banner, &Banner::actionTriggered, this, [this, subject] {
            // The action may hide its own banner.
            if (const auto action = m_actions.value(subject))
                action();
        });
    }
    m_actions.insert(subject, message.action);
    banner->setMessage(message.kind, message.text);
    banner->setAction(message.actionText);
    banner->setClosable(message.closable);
    place(banner);
    banner->show();
    setVisible(true);
}

void BannerArea::place(Banner* banner)
{
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->removeWidget(banner);
    int index = 0;
    while (index < column->count()) {
        const auto* other = qobject_cast<Banner*>(column->itemAt(index)->widget());
        if (other && other->kind() < banner->kind())
            break;
        ++index;
    }
    column->insertWidget(index, banner);
}

void BannerArea::hideMessage(const QString& subject)
{
    if (Banner* banner = m_banners.take(subject)) {
        m_actions.remove(subject);
        banner->hide();
        banner->deleteLater();
    }
    setVisible(!m_banners.isEmpty());
}

void BannerArea::clear()
{
    for (const QString& subject : m_banners.keys())
        hideMessage(subject);
}

Banner* BannerArea::find(const QString& subject) const { return m_banners.value(subject); }

} // namespace lds::ui

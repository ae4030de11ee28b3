#include "line_icon.h"

#include <QFile>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace lds::ui {

LineIcon::LineIcon(QString path, ColorRole role)
    : m_path(std::move(path))
    , m_role(role)
{}

QColor LineIcon::colorFor(QIcon::Mode mode) const
{
    QColor result = color(m_role);
    if (mode == QIcon::Disabled)
        result.setAlphaF(0.4F);
    return result;
}

void LineIcon::paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state)
{
    const qreal scale = painter->device() ? painter->device()->devicePixelRatio() : 1.0;
    painter->drawPixmap(rect, scaledPixmap(rect.size() * scale, mode, state, scale));
}

QPixmap LineIcon::pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state)
{
    return scaledPixmap(size, mode, state, 1.0);
}

QPixmap LineIcon::scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, qreal)
{
    const QColor ink = colorFor(mode);
    const QString cacheKey = QStringLiteral("lds:%1:%2x%3:%4")
                                 .arg(m_path, QString::number(size.width()), QString::number(size.height()),
                                      ink.name(QColor::HexArgb));
    QPixmap pixmap;
    if (QPixmapCache::find(cacheKey, &pixmap))
        return pixmap;
    QFile file(m_path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QByteArray drawing = file.readAll();
    drawing.replace("currentColor", ink.name(QColor::HexRgb).toLatin1());
    QSvgRenderer renderer(drawing);
    pixmap = QPixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setOpacity(ink.alphaF());
    renderer.render(&painter, QRectF(QPointF(), QSizeF(size)));
    painter.end();
    QPixmapCache::insert(cacheKey, pixmap);
    return pixmap;
}

QString LineIcon::key() const { return QStringLiteral("lds-line-icon"); }

} // namespace lds::ui

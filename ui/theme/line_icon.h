#pragma once

#include "theme.h"

#include <QIconEngine>

namespace lds::ui {

/// Draws a line icon in a colour of the theme as it is when painting, so that icons follow the theme.
class LineIcon final : public QIconEngine {
public:
    LineIcon(QString path, ColorRole role);

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override;
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override;
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal scale) override;
    QIconEngine* clone() const override { return new LineIcon(*this); }
    QString key() const override;
    bool isNull() override { return false; }

private:
    QColor colorFor(QIcon::Mode mode) const;

    QString m_path;
    ColorRole m_role;
};

} // namespace lds::ui

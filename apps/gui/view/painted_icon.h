/// Icons that are painted anew at each size and in each palette.
#pragma once

#include <QIconEngine>
#include <QPainter>
#include <QPixmap>

namespace gui {

/// Has pixmap() by paint().
class PaintedIcon : public QIconEngine {
  public:
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paint(&painter, picture.rect(), mode, state);
        return picture;
    }
};

} // namespace gui

#include "gui/panels/view_list.h"

#include <QAction>
#include <QPainter>
#include <QWidget>

namespace gui {

QIcon viewIcon(const QImage& picture, const QSize& size, double ratio, const QColor& empty) {
    QPixmap pixmap(size * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(picture.isNull() && empty.isValid() ? empty : QColor(Qt::transparent));
    if (!picture.isNull()) {
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        QRectF area(QPointF(), QSizeF(picture.size()).scaled(size, Qt::KeepAspectRatio));
        area.moveCenter(QRectF(QPointF(), QSizeF(size)).center());
        painter.drawImage(area, picture);
    }
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected); // no veil of the selection's colour
    return icon;
}

QAction* addKey(QWidget& widget, const QKeySequence& key) {
    auto* action = new QAction(&widget);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    widget.addAction(action);
    return action;
}

} // namespace gui

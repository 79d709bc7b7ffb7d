#include "gui/panels/view_list.h"

#include "gui/models/plain_text.h"

#include <QAction>
#include <QListWidget>
#include <QPainter>
#include <QWidget>

#include <utility>

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

void prepareList(QListWidget& list, QStringList& names, const QList<BookmarkRow>& rows) {
    QStringList now;
    for (const BookmarkRow& row : rows) now.append(row.name);
    if (std::exchange(names, now) == now) return;
    list.clear();
    for (const QString& name : now) {
        auto* const item = new QListWidgetItem(name, &list);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
}

// Whatever changes of an item sets the text of its editor back.
void showView(QListWidget& list, int row, const QString& name, const QIcon& icon, const QString& tip) {
    QListWidgetItem* const item = list.item(row);
    if (list.isPersistentEditorOpen(item)) return; // as any other is that is open
    item->setText(name);
    item->setIcon(icon);
    item->setToolTip(plainTip(tip));
}

QAction* addKey(QWidget& widget, const QKeySequence& key) {
    auto* action = new QAction(&widget);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    widget.addAction(action);
    return action;
}

} // namespace gui

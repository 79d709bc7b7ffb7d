/// The two lists of saved views have these in common: their images, and keys of their own.
#pragma once

#include <QColor>
#include <QIcon>
#include <QImage>
#include <QKeySequence>
#include <QSize>
#include <QString>

class QAction;
class QWidget;

namespace gui {

/// One saved view, as it is shown.
struct BookmarkRow {
    QString name;
    QImage picture; ///< may be null
};

/// The image in the middle of a size, in pixels of the screen times `ratio`, so that all are of one size; a
/// selection does not colour it. Without an image it is of the colour `empty`, if that is one.
QIcon viewIcon(const QImage& picture, const QSize& size, double ratio, const QColor& empty = {});

/// A key that works while the widget has the focus.
QAction* addKey(QWidget& widget, const QKeySequence& key);

} // namespace gui

/// The two lists of saved views have these in common: their images, and keys of their own.
#pragma once

#include <QColor>
#include <QIcon>
#include <QImage>
#include <QKeySequence>
#include <QList>
#include <QSize>
#include <QString>
#include <QStringList>

class QAction;
class QListWidget;
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

/// Makes an item for each row, which can be edited; those that are there stay where the names are as before.
void prepareList(QListWidget& list, QStringList& names, const QList<BookmarkRow>& rows);

/// Gives an item its name, icon and tip, but one whose name is being typed.
void showView(QListWidget& list, int row, const QString& name, const QIcon& icon, const QString& tip);

/// A key that works while the widget has the focus.
QAction* addKey(QWidget& widget, const QKeySequence& key);

} // namespace gui

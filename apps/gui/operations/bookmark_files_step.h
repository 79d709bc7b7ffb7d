/// A change of the files of bookmarks that can be taken back: some are deleted, replaced, or get other names.
#pragma once

#include "gui/models/bookmark_store.h"

#include <QList>
#include <QString>
#include <QUndoCommand>

#include <functional>

namespace gui {

class BookmarkFilesStep : public QUndoCommand {
  public:
    using Changed = std::function<void(const QString& trouble)>;

    /// `before`, which are there, give way to `after`. `changed` is called after each change, with what went
    /// wrong, if anything did. `store` must outlive it.
    BookmarkFilesStep(const QString& text, BookmarkStore& store, QList<BookmarkFiles> before,
                      QList<BookmarkFiles> after, Changed changed);

    void undo() override { put(after_, before_); }
    void redo() override { put(before_, after_); }

  private:
    void put(const QList<BookmarkFiles>& gone, const QList<BookmarkFiles>& there);

    BookmarkStore& store_;
    QList<BookmarkFiles> before_, after_;
    Changed changed_;
};

} // namespace gui

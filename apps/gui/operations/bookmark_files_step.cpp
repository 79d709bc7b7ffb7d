#include "gui/operations/bookmark_files_step.h"

#include <algorithm>
#include <utility>

namespace gui {

BookmarkFilesStep::BookmarkFilesStep(const QString& text, BookmarkStore& store, QList<BookmarkFiles> before,
                                     QList<BookmarkFiles> after, Changed changed)
    : QUndoCommand(text), store_(store), before_(std::move(before)), after_(std::move(after)),
      changed_(std::move(changed)) {}

// What is new first: what cannot be written costs nothing.
void BookmarkFilesStep::put(const QList<BookmarkFiles>& gone, const QList<BookmarkFiles>& there) {
    QString trouble;
    for (const BookmarkFiles& files : there)
        if (trouble.isEmpty()) trouble = store_.write(files);
    for (const BookmarkFiles& files : gone) {
        const bool stays = std::any_of(there.begin(), there.end(),
                                       [&](const BookmarkFiles& each) { return each.file == files.file; });
        if (trouble.isEmpty() && !stays) trouble = store_.remove({files.file, {}});
    }
    changed_(trouble);
}

} // namespace gui

#include "gui/operations/bookmark_operations.h"

#include "gui/operations/actions.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/panels/bookmarks_panel.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include <QListWidget>
#include <QShortcut>
#include <QUndoCommand>

namespace gui {

namespace {

constexpr int kKeys = 9;
constexpr QSize kPicture{320, 200}; ///< sharp on a screen of twice the density, too

/// Deleting, as far as it can be taken back.
class Deletion : public QUndoCommand {
  public:
    Deletion(BookmarkStore& store, const Bookmark& bookmark, std::function<void(const QString&)> changed)
        : QUndoCommand(BookmarkOperations::tr("delete “%1”").arg(bookmark.name)), store_(store),
          bookmark_(bookmark), files_(store.read(bookmark)), changed_(std::move(changed)) {}
    void undo() override { changed_(store_.write(files_)); }
    void redo() override { changed_(store_.remove(bookmark_)); }

  private:
    BookmarkStore& store_;
    Bookmark bookmark_;
    BookmarkFiles files_;
    std::function<void(const QString&)> changed_;
};

} // namespace

BookmarkOperations::BookmarkOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new BookmarksPanel) {
    addPanel(context_, panel_, tr("Bookmarks"), QStringLiteral("bookmarks"), ActionId::BookmarksPanel);
    context_.actions.on(ActionId::AddBookmark, [this] { addBookmark(); });
    connect(panel_, &BookmarksPanel::addWanted, this, &BookmarkOperations::addBookmark);
    connect(panel_, &BookmarksPanel::goWanted, this, &BookmarkOperations::go);
    // Not while the list is still busy with its editor.
    connect(panel_, &BookmarksPanel::renameWanted, this, &BookmarkOperations::rename, Qt::QueuedConnection);
    connect(panel_, &BookmarksPanel::deleteWanted, this, &BookmarkOperations::remove);
    connect(&context_.editor, &SceneEditor::sceneChanged, this, [this] {
        store_.setScene(context_.editor.scene());
        refill();
    });
    connect(&context_.session, &Session::stateChanged, panel_,
            [this] { panel_->setServerThere(context_.session.live()); });
    addKeys();
}

void BookmarkOperations::addKeys() {
    for (int i = 0; i < kKeys; ++i) {
        auto* key =
            new QShortcut(QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + i)), &context_.window);
        connect(key, &QShortcut::activated, this, [this, i] { go(i); });
    }
}

void BookmarkOperations::tellTrouble(const QString& text) {
    if (!text.isEmpty()) context_.notice.explain(text, {});
}

void BookmarkOperations::refill() {
    QList<BookmarkRow> rows;
    for (const Bookmark& bookmark : store_.list()) rows.append({bookmark.name, store_.picture(bookmark)});
    panel_->show(rows);
}

void BookmarkOperations::addBookmark() {
    if (!context_.session.live()) return;
    context_.session.send(command::scene(), this, [this](const Answer& answer) {
        if (answer.done) store_.setScene(answer.text);
    });
    context_.session.send(command::cameraGet(), this, [this](const Answer& answer) {
        answer.done ? keepWithPicture(answer.text.toUtf8() + '\n') : tellTrouble(answer.text);
    });
}

// While something moves, the frame that is there was drawn before the camera was asked for; the next one was
// not. None comes where a key is down that moves nothing, such as the Control of Ctrl+B in flight.
void BookmarkOperations::keepWithPicture(const QByteArray& camera) {
    const auto keepNow = [this, camera] {
        const QImage seen = context_.view.showsLive() ? context_.session.frame() : context_.view.picture();
        keep(camera,
             seen.isNull() ? seen : seen.scaled(kPicture, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    };
    const ServerStatus& status = context_.session.status();
    if (status.idle || status.paused || !context_.view.showsLive()) return keepNow();
    auto* once = new QObject(this);
    const auto keepOnce = [this, once, keepNow] {
        context_.session.disconnect(once);
        once->deleteLater();
        keepNow();
    };
    connect(&context_.session, &Session::frameChanged, once, keepOnce);
    connect(&context_.session, &Session::statusChanged, once, [this, keepOnce] {
        if (context_.session.status().idle) keepOnce();
    });
    connect(&context_.session, &Session::stateChanged, once, keepOnce);
}

void BookmarkOperations::keep(const QByteArray& camera, const QImage& picture) {
    const QString name = store_.freeName();
    const QString trouble = store_.add(name, camera, picture);
    if (!trouble.isEmpty()) return tellTrouble(trouble);
    refill();
    const int last = static_cast<int>(store_.list().size()) - 1;
    panel_->list().setCurrentRow(last);
    context_.view.tell(last < kKeys ? tr("Bookmark “%1” added. Alt+%2 goes there.").arg(name).arg(last + 1)
                                    : tr("Bookmark “%1” added.").arg(name));
}

void BookmarkOperations::go(int row) {
    const QList<Bookmark> all = store_.list();
    if (!context_.session.live()) return;
    if (row < 0 || row >= all.size()) return context_.view.tell(tr("There is no bookmark %1.").arg(row + 1));
    const Bookmark bookmark = all[row];
    const std::string line = command::loadCamera(store_.cameraPath(bookmark).toStdString());
    context_.editor.edit(line, [this, bookmark](const Answer& answer) {
        if (answer.done) return context_.view.tell(bookmark.name);
        tellTrouble(answer.text);
        refill(); // the file may have been removed
    });
}

void BookmarkOperations::rename(int row, const QString& name) {
    const QList<Bookmark> all = store_.list();
    if (row >= 0 && row < all.size()) tellTrouble(store_.rename(all[row], name));
    refill();
}

void BookmarkOperations::remove(int row) {
    const QList<Bookmark> all = store_.list();
    if (row < 0 || row >= all.size()) return;
    context_.editor.doOwn(new Deletion(store_, all[row], [this](const QString& trouble) {
        tellTrouble(trouble);
        refill();
    }));
}

} // namespace gui

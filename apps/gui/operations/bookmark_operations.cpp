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

BookmarkOperations::BookmarkOperations(const Desk& desk, QObject* parent)
    : QObject(parent), desk_(desk), panel_(new BookmarksPanel) {
    addPanel(desk_, panel_, tr("Bookmarks"), QStringLiteral("bookmarks"), ActionId::BookmarksPanel);
    desk_.actions.on(ActionId::AddBookmark, [this] { addBookmark(); });
    connect(panel_, &BookmarksPanel::addWanted, this, &BookmarkOperations::addBookmark);
    connect(panel_, &BookmarksPanel::goWanted, this, &BookmarkOperations::go);
    // Not while the list is still busy with its editor.
    connect(panel_, &BookmarksPanel::renameWanted, this, &BookmarkOperations::rename, Qt::QueuedConnection);
    connect(panel_, &BookmarksPanel::deleteWanted, this, &BookmarkOperations::remove);
    connect(&desk_.editor, &SceneEditor::sceneChanged, this, [this] {
        store_.setScene(desk_.editor.scene());
        refill();
    });
    connect(&desk_.session, &Session::stateChanged, panel_,
            [this] { panel_->setServerThere(desk_.session.live()); });
    addKeys();
}

void BookmarkOperations::addKeys() {
    for (int i = 0; i < kKeys; ++i) {
        auto* key = new QShortcut(QKeySequence(Qt::ALT | static_cast<Qt::Key>(Qt::Key_1 + i)), &desk_.window);
        connect(key, &QShortcut::activated, this, [this, i] { go(i); });
    }
}

void BookmarkOperations::tellTrouble(const QString& text) {
    if (!text.isEmpty()) desk_.notice.explain(text, {});
}

void BookmarkOperations::refill() {
    QList<BookmarkRow> rows;
    for (const Bookmark& bookmark : store_.list()) rows.append({bookmark.name, store_.picture(bookmark)});
    panel_->show(rows);
}

void BookmarkOperations::addBookmark() {
    if (!desk_.session.live()) return;
    desk_.session.send(command::scene(), this, [this](const Answer& answer) {
        if (answer.done) store_.setScene(answer.text);
    });
    desk_.session.send(command::cameraGet(), this, [this](const Answer& answer) {
        answer.done ? keepWithPicture(answer.text.toUtf8() + '\n') : tellTrouble(answer.text);
    });
}

// While something moves, the frame that is there was drawn before the camera was asked for; the next one was
// not. None comes where a key is down that moves nothing, such as the Control of Ctrl+B in flight.
void BookmarkOperations::keepWithPicture(const QByteArray& camera) {
    const auto keepNow = [this, camera] {
        const QImage seen = desk_.view.showsLive() ? desk_.session.frame() : desk_.view.picture();
        keep(camera,
             seen.isNull() ? seen : seen.scaled(kPicture, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    };
    const ServerStatus& status = desk_.session.status();
    if (status.idle || status.paused || !desk_.view.showsLive()) return keepNow();
    auto* once = new QObject(this);
    const auto keepOnce = [this, once, keepNow] {
        desk_.session.disconnect(once);
        once->deleteLater();
        keepNow();
    };
    connect(&desk_.session, &Session::frameChanged, once, keepOnce);
    connect(&desk_.session, &Session::statusChanged, once, [this, keepOnce] {
        if (desk_.session.status().idle) keepOnce();
    });
    connect(&desk_.session, &Session::stateChanged, once, keepOnce);
}

void BookmarkOperations::keep(const QByteArray& camera, const QImage& picture) {
    const QString name = store_.freeName();
    const QString trouble = store_.add(name, camera, picture);
    if (!trouble.isEmpty()) return tellTrouble(trouble);
    refill();
    const int last = static_cast<int>(store_.list().size()) - 1;
    panel_->list().setCurrentRow(last);
    desk_.view.tell(last < kKeys ? tr("%1 was kept. Alt+%2 goes there.").arg(name).arg(last + 1)
                                 : tr("%1 was kept.").arg(name));
}

void BookmarkOperations::go(int row) {
    const QList<Bookmark> all = store_.list();
    if (!desk_.session.live()) return;
    if (row < 0 || row >= all.size()) return desk_.view.tell(tr("There is no bookmark %1.").arg(row + 1));
    const Bookmark bookmark = all[row];
    const std::string line = command::loadCamera(store_.cameraPath(bookmark).toStdString());
    desk_.editor.place(line, bookmark.name, [this, bookmark](const Answer& answer) {
        if (answer.done) return desk_.view.tell(bookmark.name);
        tellTrouble(answer.text);
        refill(); // somebody may have taken the file away
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
    desk_.editor.undoStack().push(new Deletion(store_, all[row], [this](const QString& trouble) {
        tellTrouble(trouble);
        refill();
    }));
}

} // namespace gui

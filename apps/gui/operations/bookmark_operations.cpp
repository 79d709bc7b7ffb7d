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

#include <algorithm>
#include <utility>

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
    connect(&context_.editor, &SceneEditor::stateChanged, this, &BookmarkOperations::onState);
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

QList<BookmarkOperations::Entry> BookmarkOperations::entries() const {
    QList<Entry> all;
    for (const QString& name : context_.editor.state().bookmarks) all.append({name, true, std::nullopt});
    for (const Bookmark& bookmark : store_.list()) {
        const auto same = std::find_if(all.begin(), all.end(), [&](const Entry& each) {
            return each.ofScene && !each.kept && fileNameOf(each.name) == bookmark.name;
        });
        if (same == all.end()) {
            all.append({bookmark.name, false, bookmark});
        } else {
            same->kept = bookmark;
        }
    }
    return all;
}

void BookmarkOperations::refill() {
    QList<BookmarkRow> rows;
    for (const Entry& entry : entries())
        rows.append({entry.name, entry.kept ? store_.picture(*entry.kept) : QImage()});
    shown_ = context_.editor.state().bookmarks;
    panel_->show(rows);
}

// Whichever client or step of undo changed them.
void BookmarkOperations::onState() {
    if (context_.editor.state().bookmarks != shown_) refill();
}

void BookmarkOperations::giveToScene() {
    bool first = true;
    for (const Entry& entry : entries()) {
        if (entry.ofScene) continue;
        const std::string line =
            command::bookmarkAdd(entry.name.toStdString(), store_.cameraPath(*entry.kept).toStdString());
        context_.editor.edit(std::exchange(first, false) ? line : command::also(line),
                             [this](const Answer& answer) {
                                 if (!answer.done) tellTrouble(answer.text);
                             });
    }
}

void BookmarkOperations::follow(const QString& scene) {
    tellTrouble(store_.copyTo(scene));
    store_.setScene(scene);
    refill();
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
    const QString name = store_.freeName(context_.editor.state().bookmarks);
    const QString trouble = store_.add(name, camera, picture);
    if (!trouble.isEmpty()) return tellTrouble(trouble);
    refill();
    const int last = static_cast<int>(entries().size()) - 1;
    panel_->list().setCurrentRow(last);
    context_.view.tell(
        last < kKeys ? tr("Bookmark “%1” added. Alt+%2 goes there.").arg(name, QString::number(last + 1))
                     : tr("Bookmark “%1” added.").arg(name));
}

void BookmarkOperations::go(int row) {
    const QList<Entry> all = entries();
    if (!context_.session.live()) return;
    if (row < 0 || row >= all.size()) return context_.view.tell(tr("There is no bookmark %1.").arg(row + 1));
    const Entry& entry = all[row];
    const std::string line = entry.ofScene
                                 ? command::bookmarkGo(entry.name.toStdString())
                                 : command::loadCamera(store_.cameraPath(*entry.kept).toStdString());
    context_.editor.edit(line, [this, name = entry.name](const Answer& answer) {
        if (answer.done) return context_.view.tell(name);
        tellTrouble(answer.text);
        refill(); // the file may have been removed
    });
}

void BookmarkOperations::rename(int row, const QString& name) {
    const QList<Entry> all = entries();
    if (row >= 0 && row < all.size() && !name.trimmed().isEmpty()) {
        const Entry& entry = all[row];
        if (entry.kept) tellTrouble(store_.rename(*entry.kept, name));
        if (entry.ofScene)
            context_.editor.edit(command::bookmarkRename(entry.name.toStdString(), name.toStdString()));
    }
    refill();
}

void BookmarkOperations::remove(int row) {
    const QList<Entry> all = entries();
    if (row < 0 || row >= all.size()) return;
    const Entry& entry = all[row];
    if (entry.kept) {
        context_.editor.doOwn(new Deletion(store_, *entry.kept, [this](const QString& trouble) {
            tellTrouble(trouble);
            refill();
        }));
    }
    if (entry.ofScene) context_.editor.edit(command::bookmarkRemove(entry.name.toStdString()));
}

} // namespace gui

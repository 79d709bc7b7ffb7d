#include "gui/operations/bookmark_operations.h"

#include "gui/operations/actions.h"
#include "gui/operations/bookmark_files_step.h"
#include "gui/operations/panel_operations.h"
#include "gui/operations/scene_editor.h"
#include "gui/operations/visit_picture.h"
#include "gui/panels/bookmarks_panel.h"
#include "gui/panels/views_strip.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include <QListWidget>
#include <QShortcut>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace gui {

namespace {

constexpr int kKeys = 9;

} // namespace

BookmarkOperations::BookmarkOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), panel_(new BookmarksPanel), strip_(new ViewsStrip),
      visit_(new VisitPicture(context, this)) {
    addPanels();
    context_.actions.on(ActionId::AddBookmark, [this] { addBookmark(); });
    connect(&context_.editor, &SceneEditor::sceneChanged, this, [this] {
        setScene(context_.editor.scene());
        refill();
    });
    connect(&context_.editor, &SceneEditor::stateChanged, this, &BookmarkOperations::onState);
    connect(&context_.session, &Session::stateChanged, this, [this] {
        panel_->setServerThere(context_.session.live());
        strip_->setServerThere(context_.session.live());
    });
    addKeys();
}

// Both show the same, and want the same.
void BookmarkOperations::addPanels() {
    addPanel(context_, panel_, tr("Bookmarks"), QStringLiteral("bookmarks"), ActionId::BookmarksPanel);
    addPanel(context_, strip_, tr("Views"), QStringLiteral("views"), ActionId::ViewsStrip,
             Qt::BottomDockWidgetArea);
    const auto connectAll = [this](auto* panel) {
        using Panel = std::remove_pointer_t<decltype(panel)>;
        connect(panel, &Panel::addWanted, this, &BookmarkOperations::addBookmark);
        connect(panel, &Panel::goWanted, this, &BookmarkOperations::go);
        // Not while the list is still busy with its editor.
        connect(panel, &Panel::renameWanted, this, &BookmarkOperations::rename, Qt::QueuedConnection);
        connect(panel, &Panel::deleteWanted, this, &BookmarkOperations::remove);
    };
    connectAll(panel_);
    connectAll(strip_);
    connect(strip_, &ViewsStrip::replaceWanted, this, &BookmarkOperations::replace);
    connect(strip_, &ViewsStrip::moveWanted, this, &BookmarkOperations::move);
}

void BookmarkOperations::setScene(const QString& scene) {
    store_.setScene(scene);
    pictures_.setScene(scene);
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
    const SceneState& state = context_.editor.state();
    for (qsizetype i = 0; i < state.bookmarks.size(); ++i)
        all.append({state.bookmarks[i], true, state.bookmarkViews.value(i), std::nullopt});
    for (const Bookmark& bookmark : store_.list()) {
        const auto same = std::find_if(all.begin(), all.end(), [&](const Entry& each) {
            return each.ofScene && !each.kept && fileNameOf(each.name) == bookmark.name;
        });
        if (same == all.end()) {
            all.append({bookmark.name, false, {}, bookmark});
        } else {
            same->kept = bookmark;
        }
    }
    return all;
}

QImage BookmarkOperations::pictureOf(const Entry& entry) const {
    const QImage own = pictures_.picture(entry.view);
    return own.isNull() && entry.kept ? store_.picture(*entry.kept) : own;
}

void BookmarkOperations::refill() {
    QList<BookmarkRow> rows;
    for (const Entry& entry : entries()) rows.append({entry.name, pictureOf(entry)});
    shown_ = context_.editor.state().bookmarks + context_.editor.state().bookmarkViews;
    panel_->show(rows);
    strip_->show(rows);
}

// Whichever client or step of undo changed them.
void BookmarkOperations::onState() {
    takeReplaced();
    if (context_.editor.state().bookmarks + context_.editor.state().bookmarkViews != shown_) refill();
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
    const QList<Entry> all = entries();
    QList<QImage> pictures;
    for (const Entry& entry : all) pictures.append(pictureOf(entry));
    setScene(scene);
    for (qsizetype i = 0; i < all.size(); ++i) pictures_.keep(all[i].view, pictures[i]);
    refill();
}

void BookmarkOperations::addBookmark() {
    if (!context_.session.live()) return;
    context_.session.send(command::scene(), this, [this](const Answer& answer) {
        if (answer.done) setScene(answer.text);
    });
    takeView([this](const QByteArray& camera, const QImage& picture) { keep(camera, picture); });
}

void BookmarkOperations::takeView(const Keep& keep) {
    context_.session.send(command::cameraGet(), this, [this, keep](const Answer& answer) {
        answer.done ? takePicture(answer.text.toUtf8() + '\n', keep) : tellTrouble(answer.text);
    });
}

// While something moves, the frame that is there was drawn before the camera was asked for; the next one was
// not. None comes where a key is down that moves nothing, such as the Control of Ctrl+B in flight.
void BookmarkOperations::takePicture(const QByteArray& camera, const Keep& keep) {
    const auto keepNow = [this, camera, keep] { keep(camera, smallPicture(context_)); };
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
    strip_->list().setCurrentRow(last);
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
        visit_->end();
        tellTrouble(answer.text);
        refill(); // the file may have been removed
    });
    visit_->begin([this, name = entry.name](const QImage& picture) { keepPicture(name, picture); });
}

// Where it is still there: in its file, or in the cache.
void BookmarkOperations::keepPicture(const QString& name, const QImage& picture) {
    for (const Entry& entry : entries()) {
        if (entry.name != name) continue;
        entry.ofScene ? pictures_.keep(entry.view, picture)
                      : tellTrouble(store_.keepPicture(*entry.kept, picture));
        return refill();
    }
}

QString BookmarkOperations::viewOf(const QString& name) const {
    const SceneState& state = context_.editor.state();
    return state.bookmarkViews.value(state.bookmarks.indexOf(name));
}

// Of a view that the state may not have yet.
void BookmarkOperations::keepReplaced(const Entry& before, const QImage& picture) {
    replaced_ = {before.name, before.view, picture};
    takeReplaced();
}

void BookmarkOperations::takeReplaced() {
    if (!replaced_) return;
    const QString now = viewOf(replaced_->name);
    if (now == replaced_->before) return;
    pictures_.keep(now, replaced_->picture);
    replaced_.reset();
    refill();
}

void BookmarkOperations::rename(int row, const QString& name) {
    const QList<Entry> all = entries();
    if (row >= 0 && row < all.size() && !name.trimmed().isEmpty()) {
        const Entry& entry = all[row];
        std::string line;
        if (entry.ofScene) line = command::bookmarkRename(entry.name.toStdString(), name.toStdString());
        const bool kept = entry.kept && renameKept(*entry.kept, name, line);
        if (!kept && !line.empty())
            context_.editor.edit(line, [this](const Answer& answer) {
                if (!answer.done) tellTrouble(answer.text);
                refill();
            });
    }
    refill();
}

/// Together with the edit `line` of the scene, if any; false: it was not done, and told.
bool BookmarkOperations::renameKept(const Bookmark& bookmark, const QString& name, const std::string& line) {
    const BookmarkFiles before = store_.read(bookmark), after = store_.renamed(bookmark, name);
    if (after.file.isEmpty() || before.camera.isEmpty()) return false; // no other name, or removed meanwhile
    if (store_.has(after.file)) {
        tellTrouble(tr("There is a bookmark “%1” already.").arg(name));
        return false;
    }
    change(tr("rename “%1”").arg(bookmark.name), {before}, {after}, line);
    return true;
}

void BookmarkOperations::replace(int row) {
    const QList<Entry> all = entries();
    if (row < 0 || row >= all.size() || !context_.session.live()) return;
    pictures_.keep(all[row].view, pictureOf(all[row])); // for undo
    if (all[row].ofScene && !all[row].kept)
        context_.editor.edit(command::bookmarkAdd(all[row].name.toStdString()));
    takeView([this, entry = all[row]](const QByteArray& camera, const QImage& picture) {
        if (entry.kept) replaceKept(entry, camera, picture);
        if (entry.ofScene) keepReplaced(entry, picture);
        context_.view.tell(tr("“%1” is the current view now.").arg(entry.name));
    });
}

// By the camera that the file has by then.
void BookmarkOperations::replaceKept(const Entry& entry, const QByteArray& camera, const QImage& picture) {
    const Bookmark& bookmark = *entry.kept;
    const BookmarkFiles before = store_.read(bookmark);
    std::string line;
    if (entry.ofScene)
        line = command::bookmarkAdd(entry.name.toStdString(), store_.cameraPath(bookmark).toStdString());
    if (before.camera.isEmpty()) { // it was removed meanwhile
        if (entry.ofScene) context_.editor.edit(command::bookmarkAdd(entry.name.toStdString()));
        return refill();
    }
    change(tr("replace “%1”").arg(bookmark.name), {before},
           {{bookmark.file, camera, picture.isNull() ? before.picture : pictureBytes(picture)}}, line);
}

// The scene's own come first, and stay first.
void BookmarkOperations::move(int row, int by) {
    const QList<Entry> all = entries();
    const int to = row + by;
    if (row < 0 || to < 0 || std::max(row, to) >= all.size()) return refill();
    const Entry &moved = all[row], &other = all[to];
    if (moved.ofScene && other.ofScene)
        return context_.editor.edit(command::bookmarkMove(moved.name.toStdString(), to + 1),
                                    [this](const Answer& answer) {
                                        if (!answer.done) refill();
                                    });
    if (!moved.ofScene && !other.ofScene) return moveKept(*moved.kept, *other.kept);
    context_.view.tell(tr("Bookmarks of the scene come first."));
    refill();
}

void BookmarkOperations::moveKept(const Bookmark& bookmark, const Bookmark& other) {
    const QList<BookmarkFiles> after = store_.exchanged(bookmark, other);
    if (after.isEmpty()) return refill();
    change(tr("move “%1”").arg(bookmark.name), {store_.read(bookmark), store_.read(other)}, after);
}

void BookmarkOperations::change(const QString& text, const QList<BookmarkFiles>& before,
                                const QList<BookmarkFiles>& after, const std::string& line) {
    auto* step = new BookmarkFilesStep(text, store_, before, after, [this](const QString& trouble) {
        tellTrouble(trouble);
        refill();
    });
    line.empty() ? context_.editor.doOwn(step) : context_.editor.doBoth(step, line);
}

void BookmarkOperations::remove(int row) {
    const QList<Entry> all = entries();
    if (row < 0 || row >= all.size()) return;
    const Entry& entry = all[row];
    std::string line;
    if (entry.ofScene) line = command::bookmarkRemove(entry.name.toStdString());
    if (entry.kept) return change(tr("delete “%1”").arg(entry.name), {store_.read(*entry.kept)}, {}, line);
    context_.editor.edit(line);
}

} // namespace gui

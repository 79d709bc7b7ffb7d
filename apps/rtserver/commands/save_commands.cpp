// Commands that save the scene, and those for its bookmarks.
#include "rtserver/commands/command_call.h"
#include "rtserver/document/exports.h"
#include "rtserver/document/scene_pack.h"
#include "rtserver/document/scene_saving.h"

#include "common/commands/pack_words.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"
#include "rtcore/settings/utf8.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace rtserver {

namespace {

namespace fs = std::filesystem;

fs::path sourceOf(const Document& document) {
    return fs::absolute(document.world().source).lexically_normal();
}

// Edits that are made while the file is written are not in it.
Result saveTo(const Call& call, const fs::path& path, bool replace) {
    rtcore::SceneFile file = savedSceneOf(call.document());
    if (path != sourceOf(call.document())) file.output.reset(); // the image of the scene it was
    return {.when = ReplyWhen::Beside,
            .work = [path, replace, file = std::move(file), inputs = call.document().world().inputs,
                     at = call.document().history().state(), &document = call.document()]() -> Finish {
                refuseInput(inputs, path, ".scn");
                saveScene(path, file, replace);
                return [path, at, &document] {
                    document.noteSaved(path, at);
                    return path.string();
                };
            }};
}

Result save(const Call& call) {
    const fs::path path = sourceOf(call.document());
    if (path.extension() != ".scn")
        throw rtcore::Refusal("a model is shown, not a scene; 'save as' makes a scene of it");
    return saveTo(call, path, call.size() > 0);
}

Result saveAs(const Call& call) { return saveTo(call, pathOf(call[0]), call.size() > 1); }

// --- Packing ---

ScenePack packOf(const Document& document, bool outside) {
    const rtcore::LoadedScene& loaded = document.world().loaded;
    ScenePack pack{.scene = savedSceneOf(document),
                   .source = document.world().source,
                   .modelFiles = loaded.modelFiles,
                   .contents = {},
                   .outside = outside};
    if (!loaded.sceneFile) return pack;
    for (const auto& file : {loaded.sceneFile->settings, loaded.sceneFile->cameraFile})
        if (file) pack.contents.push_back(*file);
    return pack;
}

std::string answerOf(const PackedScene& packed) {
    std::string text = fmt::format("{} files", packed.files);
    for (const fs::path& file : packed.leftOut)
        text += '\n' + rtcore::say(app::kLeftOut, rtcore::printable(file.string())).english();
    return text;
}

Result pack(const Call& call) {
    Workspace& state = call.state;
    if (state.packing)
        throw rtcore::FileError(rtcore::FailureKind::TryAgain, "",
                                "a pack is being made already; wait for it, or give it up by 'pack stop'");
    const fs::path path = pathOf(call[0]);
    ScenePack scene = packOf(call.document(), call.size() > 1);
    const auto progress = std::make_shared<PackProgress>();
    state.packing = progress;
    return {.when = ReplyWhen::Apart,
            .work = [path, scene = std::move(scene), progress, &state]() -> Finish {
                std::exception_ptr failure;
                PackedScene packed;
                try {
                    packed = packScene(path, scene, *progress);
                } catch (...) {
                    failure = std::current_exception();
                }
                return [packed, failure, &state] {
                    state.packing.reset();
                    if (failure) std::rethrow_exception(failure);
                    return answerOf(packed);
                };
            },
            .stop = {progress, &progress->stop}};
}

Result packProgress(const Call& call) {
    const std::shared_ptr<PackProgress>& packing = call.state.packing;
    return {.answer = app::packProgressText(packing ? std::optional(packing->fraction()) : std::nullopt)};
}

Result stopPacking(const Call& call) {
    if (call.state.packing) call.state.packing->stop = true;
    return {};
}

// --- Bookmarks ---

// Clients know it by the name that lists and the state tell.
rtcore::SceneBookmarks::iterator named(rtcore::SceneBookmarks& bookmarks, const std::string& name) {
    auto found = rtcore::findBookmark(bookmarks, name);
    if (found == bookmarks.end())
        found = std::ranges::find_if(std::as_const(bookmarks), [&](const rtcore::SceneBookmark& each) {
            return rtcore::printable(each.name) == name;
        });
    if (found == bookmarks.end())
        throw rtcore::BadValue(rtcore::say("the scene has no bookmark {0}", rtcore::inQuotes(name)));
    return bookmarks.begin() + (found - bookmarks.cbegin());
}

Result bookmarks(const Call& call) {
    std::string text;
    for (const rtcore::SceneBookmark& bookmark : call.document().bookmarks())
        text += (text.empty() ? "" : "\n") + rtcore::printable(bookmark.name);
    return {.answer = text};
}

// In the place of one of that name.
std::string keep(Document& document, const std::string& name, rtcore::Camera camera) {
    camera.nameOffset = 0;
    rtcore::SceneBookmarks all = document.bookmarks();
    const auto old = rtcore::findBookmark(all, name);
    if (old == all.end()) {
        all.push_back({name, camera});
    } else {
        all[static_cast<std::size_t>(old - all.cbegin())].camera = camera;
    }
    document.setBookmarks(std::move(all));
    return {};
}

void checkName(const std::string& name) {
    const bool text = rtcore::findInvalidUtf8(name) == std::string_view::npos;
    if (name.empty() || !text) throw rtcore::BadValue("a bookmark needs a name, in UTF-8");
}

Result addBookmark(const Call& call) {
    checkName(call[0]);
    if (call.size() == 1) return {.answer = keep(call.document(), call[0], call.document().camera())};
    return {.when = ReplyWhen::Beside,
            .work = [name = call[0], path = pathOf(call[1]), zero = call.document().scene()->origin,
                     &document = call.document()]() -> Finish {
                return [&document, name, camera = rtcore::readCameraFile(path, zero).camera] {
                    return keep(document, name, camera);
                };
            }};
}

Result goToBookmark(const Call& call) {
    rtcore::SceneBookmarks all = call.document().bookmarks();
    call.document().setCamera(named(all, call[0])->camera);
    return {};
}

Result renameBookmark(const Call& call) {
    checkName(call[1]);
    rtcore::SceneBookmarks all = call.document().bookmarks();
    const auto bookmark = named(all, call[0]);
    const auto other = rtcore::findBookmark(all, call[1]);
    if (other != all.end() && other != bookmark)
        throw rtcore::BadValue(rtcore::say("another bookmark is called {0}", rtcore::inQuotes(call[1])));
    bookmark->name = call[1];
    call.document().setBookmarks(std::move(all));
    return {};
}

Result moveBookmark(const Call& call) {
    rtcore::SceneBookmarks all = call.document().bookmarks();
    const auto bookmark = named(all, call[0]);
    rtcore::SceneBookmark moved = std::move(*bookmark);
    all.erase(bookmark);
    const auto before = std::min(static_cast<std::size_t>(integer(call[1]) - 1), all.size());
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(before), std::move(moved));
    call.document().setBookmarks(std::move(all));
    return {};
}

Result removeBookmark(const Call& call) {
    rtcore::SceneBookmarks all = call.document().bookmarks();
    all.erase(named(all, call[0]));
    call.document().setBookmarks(std::move(all));
    return {};
}

constexpr std::array kSaveFunctions{
    CommandFunction{app::CommandId::Save, save},
    CommandFunction{app::CommandId::SaveAs, saveAs},
    CommandFunction{app::CommandId::Pack, pack},
    CommandFunction{app::CommandId::PackProgress, packProgress},
    CommandFunction{app::CommandId::PackStop, stopPacking},
    CommandFunction{app::CommandId::Bookmarks, bookmarks},
    CommandFunction{app::CommandId::BookmarkAdd, addBookmark},
    CommandFunction{app::CommandId::BookmarkGo, goToBookmark},
    CommandFunction{app::CommandId::BookmarkRename, renameBookmark},
    CommandFunction{app::CommandId::BookmarkMove, moveBookmark},
    CommandFunction{app::CommandId::BookmarkRemove, removeBookmark},
};

} // namespace

std::span<const CommandFunction> saveFunctions() { return kSaveFunctions; }

} // namespace rtserver

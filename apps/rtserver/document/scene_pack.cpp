#include "rtserver/document/scene_pack.h"

#include "rtserver/document/packed_files.h"
#include "rtserver/document/packed_model.h"

#include "common/commands/pack_words.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/photometry/photometric_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/paths.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/platform/temporary_folder.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace rtserver {

namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

[[noreturn]] void failPacking(const fs::path& path, const rtcore::Sentence& why) {
    throw rtcore::FileError(rtcore::FailureKind::CannotWrite, path.string(),
                            rtcore::say("cannot be written: {0}", why));
}

void refuseFull(const fs::path& folder) {
    std::error_code none;
    if (!fs::is_directory(folder.parent_path(), none))
        failPacking(folder, rtcore::say("there is no such folder to make it in"));
    if (fs::exists(folder, none) && !fs::is_empty(folder, none))
        failPacking(folder, rtcore::say("it is there already, and not empty; name another folder"));
}

/// Of the scene and of its variants.
void forEachLight(rtcore::SceneFile& scene, const std::function<void(rtcore::LightDescription&)>& visit) {
    std::vector<std::vector<rtcore::LightDescription>*> lists{&scene.lights};
    for (rtcore::SceneVariant& variant : scene.variants) lists.push_back(&variant.lights);
    if (scene.shown) lists.push_back(&scene.shown->lights);
    for (auto* const list : lists)
        for (rtcore::LightDescription& light : *list) visit(light);
}

/// All that the scene names; what the pack may hold.
Paths filesOf(ScenePack& pack) {
    Paths all = pack.modelFiles;
    all.push_back(pack.scene.model);
    for (const rtcore::MaterialOverride& material : pack.scene.materials) {
        if (material.diffuseTexture) all.push_back(*material.diffuseTexture);
    }
    forEachLight(pack.scene, [&](const rtcore::LightDescription& light) {
        if (!light.file.empty()) all.push_back(light.file);
    });
    for (const rtcore::EnvironmentFile& environment : pack.scene.environments)
        all.insert(all.end(), environment.files.begin(), environment.files.end());
    return all;
}

/// Where the names lead is compared, not the names.
bool isBelow(const fs::path& folder, const fs::path& file) {
    std::error_code none; // where it is not known, it is elsewhere
    const fs::path seen = fs::weakly_canonical(file, none).lexically_relative(folder);
    return !seen.empty() && *seen.begin() != "..";
}

void refuseOutside(ScenePack& pack) {
    const fs::path folder = fs::canonical(rtcore::plainPath(pack.source).parent_path());
    Paths all = filesOf(pack), outside;
    all.insert(all.end(), pack.contents.begin(), pack.contents.end());
    for (const fs::path& file : all) {
        const fs::path plain = rtcore::plainPath(file);
        if (!isBelow(folder, plain)) outside.push_back(plain);
    }
    std::sort(outside.begin(), outside.end());
    outside.erase(std::unique(outside.begin(), outside.end()), outside.end());
    if (!outside.empty())
        throw rtcore::FileError(rtcore::FailureKind::BadData, folder.string(), app::packRefusal(outside));
}

void countBytes(ScenePack& pack, PackProgress& progress) {
    std::error_code none;
    std::set<fs::path> files;
    for (const fs::path& file : filesOf(pack)) files.insert(rtcore::plainPath(file));
    for (const fs::path& file : files) {
        const std::uintmax_t size = fs::file_size(file, none);
        if (!none) progress.all += 2 * size;
    }
}

/// The copy of a file that `decode` reads; nothing when it cannot.
std::optional<fs::path> takeChecked(const fs::path& file, const char* folder, PackedFiles& pack,
                                    const std::function<void(const fs::path&)>& decode) {
    if (!fs::is_regular_file(file)) {
        pack.noteMissing(file);
        return std::nullopt;
    }
    const fs::path copy = pack.take(file, folder);
    try {
        decode(copy);
        pack.progress().done += fs::file_size(copy);
        return copy;
    } catch (const rtcore::FileError& error) {
        if (error.kind == rtcore::FailureKind::Stopped) throw;
        pack.leaveOut(copy);
        return std::nullopt;
    }
}

void takeEnvironment(rtcore::EnvironmentFile& environment, PackedFiles& pack) {
    for (fs::path& file : environment.files) {
        const auto copy = takeChecked(file, "environments", pack,
                                      [](const fs::path& image) { (void)rtcore::readHdrImage(image); });
        if (!copy)
            throw rtcore::FileError(rtcore::FailureKind::BadData, file.string(),
                                    "it is no image any more; choose another environment map");
        file = *copy;
    }
}

void takeLuminaire(rtcore::LightDescription& light, PackedFiles& pack) {
    if (light.file.empty()) return;
    const auto copy = takeChecked(light.file, "luminaires", pack,
                                  [](const fs::path& file) { (void)rtcore::readPhotometricFile(file); });
    if (!copy)
        throw rtcore::FileError(rtcore::FailureKind::BadData, light.file.string(),
                                "it is no photometric file any more; choose another one");
    light.file = *copy;
}

void fill(PackedFiles& files, ScenePack& pack, const std::string& name) {
    rtcore::SceneFile& scene = pack.scene;
    scene.output.reset();
    scene.model = packModel(scene.model, pack.modelFiles, files);
    for (rtcore::MaterialOverride& material : scene.materials) {
        if (material.diffuseTexture)
            material.diffuseTexture =
                takeChecked(*material.diffuseTexture, "textures", files,
                            [](const fs::path& image) { (void)rtcore::readLdrImage(image); });
    }
    forEachLight(scene, [&](rtcore::LightDescription& light) { takeLuminaire(light, files); });
    for (rtcore::EnvironmentFile& environment : scene.environments) takeEnvironment(environment, files);
    const fs::path written = files.root() / name;
    rtcore::writeSceneFile(written, scene);
    fs::permissions(written, fs::status(pack.source).permissions() & fs::status(written).permissions());
}

} // namespace

PackedScene packScene(const fs::path& path, ScenePack pack, PackProgress& progress) {
    const fs::path plain = rtcore::plainPath(path);
    const fs::path folder = plain.has_filename() ? plain : plain.parent_path(); // "a/"
    refuseFull(folder);
    try {
        if (pack.modelFiles.empty()) pack.modelFiles = companionsOf(pack.scene.model, progress);
        if (!pack.outside) refuseOutside(pack);
        countBytes(pack, progress);
        // Its own mode is private; that of the folder in it is any folder's.
        const rtcore::TemporaryFolder workshop(folder.parent_path(), ".rtsuite-pack-");
        const fs::path root = workshop.path() / "pack";
        fs::create_directory(root);
        PackedFiles files(root, progress);
        fill(files, pack, pack.source.stem().string() + ".scn");
        throwIfStopped(progress);
        fs::rename(root, folder);
        return {files.count() + 1, files.leftOut()};
    } catch (const fs::filesystem_error& error) {
        failPacking(folder, rtcore::say("{0} ({1})", rtcore::systemReason(error.code().value()),
                                        error.path1().string()));
    }
}

} // namespace rtserver

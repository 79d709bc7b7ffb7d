#include "rtserver/scene_pack.h"

#include "rtcore/io/import/model_import.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/temporary_folder.h"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>

namespace rtserver {

namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

[[noreturn]] void failPacking(const fs::path& path, const std::string& why) {
    throw rtcore::FileError(rtcore::FailureKind::CannotWrite, path.string(), "cannot be written: " + why);
}

Paths normal(const Paths& files) {
    Paths all;
    for (const fs::path& file : files) all.push_back(fs::absolute(file).lexically_normal());
    return all;
}

Paths filesOfImport(const fs::path& model) {
    const rtcore::ImportReport report = rtcore::importModel(model).report;
    return normal(Paths(report.files.begin(), report.files.end()));
}

/// The folder that all are in or below.
fs::path commonFolder(const Paths& files) {
    fs::path common = files.front().parent_path();
    for (const fs::path& file : files) {
        const auto ends = std::mismatch(common.begin(), common.end(), file.begin(), file.end());
        fs::path shared;
        for (auto part = common.begin(); part != ends.first; ++part) shared /= *part;
        common = shared;
    }
    return common;
}

std::set<fs::path> seenFrom(const fs::path& folder, const Paths& files) {
    std::set<fs::path> all;
    for (const fs::path& file : files) all.insert(file.lexically_relative(folder));
    return all;
}

class Packer {
  public:
    explicit Packer(fs::path root) : root_(std::move(root)) {}

    int files() const { return static_cast<int>(copies_.size()); }

    /// Copies a file into a folder of the pack, under a name that is free there; once, however often it is
    /// asked for.
    fs::path take(const fs::path& file, const char* folder) {
        const fs::path source = fs::absolute(file).lexically_normal();
        const auto known = copies_.find(source);
        if (known != copies_.end()) return known->second;
        fs::path target = root_ / folder / source.filename();
        for (int number = 2; fs::exists(target); ++number)
            target.replace_filename(source.stem().string() + '-' + std::to_string(number) +
                                    source.extension().string());
        return copy(source, target);
    }

    /// Copies the model's files as they stand to each other. Returns the model's path there.
    fs::path takeModel(const fs::path& model, Paths files) {
        const fs::path source = fs::absolute(model).lexically_normal();
        if (files.empty()) files = filesOfImport(source);
        files = normal(files);
        files.push_back(source);
        const fs::path from = commonFolder(files), to = root_ / "model";
        for (const fs::path& file : files) {
            if (copies_.count(file) == 0) copy(file, to / file.lexically_relative(from));
        }
        const fs::path packed = copies_.at(source);
        if (source.extension() != ".bsp") checkImport(packed, seenFrom(from, files));
        return packed;
    }

  private:
    fs::path copy(const fs::path& source, const fs::path& target) {
        fs::create_directories(target.parent_path());
        fs::copy_file(source, target);
        return copies_[source] = target;
    }

    /// Whether the packed model is read from the pack alone.
    void checkImport(const fs::path& packed, const std::set<fs::path>& expected) const {
        Paths files = filesOfImport(packed);
        files.push_back(packed);
        const std::set<fs::path> found = seenFrom(root_ / "model", files);
        for (const fs::path& file : found) {
            if (!file.empty() && *file.begin() == "..")
                throw rtcore::FileError(rtcore::FailureKind::BadData, packed.filename().string(),
                                        "names " + (root_ / "model" / file).lexically_normal().string() +
                                            " by its absolute path, which no copy of the model would find; "
                                            "export it with relative "
                                            "ones, or make a .bsp of it by BSPBuilder and pack that");
        }
        for (const fs::path& file : expected) {
            if (found.count(file) == 0)
                throw rtcore::FileError(rtcore::FailureKind::BadData, packed.filename().string(),
                                        "its copy does not find " + file.string() +
                                            "; make a .bsp of it by BSPBuilder and pack that");
        }
    }

    fs::path root_;
    std::map<fs::path, fs::path> copies_; ///< by source
};

void fill(Packer& packer, ScenePack& pack, const fs::path& root) {
    rtcore::SceneFile& scene = pack.scene;
    scene.output.reset();
    scene.model = packer.takeModel(scene.model, pack.modelFiles);
    for (rtcore::MaterialOverride& material : scene.materials) {
        if (material.diffuseTexture)
            material.diffuseTexture = packer.take(*material.diffuseTexture, "textures");
    }
    for (rtcore::EnvironmentFile& environment : scene.environments) {
        for (fs::path& file : environment.files) file = packer.take(file, "environments");
    }
    rtcore::writeSceneFile(root / (pack.name + ".scn"), scene);
}

void refuseFull(const fs::path& folder) {
    std::error_code none;
    if (!fs::is_directory(folder.parent_path(), none))
        failPacking(folder, "there is no such folder to make it in");
    if (fs::exists(folder, none) && !fs::is_empty(folder, none))
        failPacking(folder, "it is there already, and not empty; name another folder");
}

} // namespace

int packScene(const fs::path& path, ScenePack pack) {
    const fs::path normalized = path.lexically_normal();
    const fs::path folder = normalized.has_filename() ? normalized : normalized.parent_path(); // "a/"
    refuseFull(folder);
    try {
        // Its own mode is private; that of the folder in it is any folder's.
        const rtcore::TemporaryFolder workshop(folder.parent_path(), ".rtsuite-pack-");
        const fs::path root = workshop.path() / "pack";
        fs::create_directory(root);
        Packer packer(root);
        fill(packer, pack, root);
        fs::rename(root, folder);
        return packer.files() + 1;
    } catch (const fs::filesystem_error& error) {
        failPacking(folder, error.code().message() + " (" + error.path1().string() + ")");
    }
}

} // namespace rtserver

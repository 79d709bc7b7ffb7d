/// A scene with all files that it needs, in a folder that can be moved.
#pragma once

#include "rtserver/document/pack_progress.h"

#include "rtcore/io/text/scn.h"

#include <filesystem>
#include <string>
#include <vector>

namespace rtserver {

struct ScenePack {
    rtcore::SceneFile scene;
    std::filesystem::path source; ///< the scene's file, or the model that was opened by itself
    /// As LoadedScene::modelFiles; empty: the model is imported to learn of them.
    std::vector<std::filesystem::path> modelFiles;
    /// Whose content `scene` has: the .set and the .cam that the scene's file named.
    std::vector<std::filesystem::path> contents;
    bool outside = false; ///< take along what lies outside of the source's folder
};

struct PackedScene {
    int files = 0;
    /// Files that the scene names and the pack does not hold: images that are none, and those that the model
    /// is the same without.
    std::vector<std::filesystem::path> leftOut;
};

/// Makes `folder`, which must not exist or be empty, beside which it is prepared: it is there with all that
/// it needs, or not at all. It holds copies of what was decoded as an image or is part of the model, and
/// nothing else that the scene names. Where files lie, all links followed, outside of the folder of
/// `pack.source`, the pack is refused with their names unless `pack.outside`; other names of one file (hard
/// links) cannot be told from it. The copy of a model is imported once to see that it finds its files there,
/// and once for each of them that is no image. Files are readable by no more users than they were. Throws
/// FileError: CannotWrite; BadData for files outside, and for a model that names its files by absolute paths;
/// Stopped; and what importModel() throws.
PackedScene packScene(const std::filesystem::path& folder, ScenePack pack, PackProgress& progress);

} // namespace rtserver

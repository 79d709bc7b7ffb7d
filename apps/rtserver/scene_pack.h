/// A scene with all files that it needs, in a folder that can be moved.
#pragma once

#include "rtcore/io/text/scn.h"

#include <filesystem>
#include <string>
#include <vector>

namespace rtserver {

struct ScenePack {
    rtcore::SceneFile scene;
    /// As LoadedScene::modelFiles; empty: the model is imported to learn of them.
    std::vector<std::filesystem::path> modelFiles;
    std::string name; ///< of the .scn, without its extension
};

/// Makes `folder`, which must not exist or be empty, beside which it is prepared: it is there with all that
/// it needs, or not at all. The copy of a model is imported once to see that it finds its files there.
/// Returns the number of files. Throws FileError: CannotWrite, and BadData for a model that names its files
/// by absolute paths; and what importModel() throws.
int packScene(const std::filesystem::path& folder, ScenePack pack);

} // namespace rtserver

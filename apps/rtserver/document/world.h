/// A scene as it was loaded, and what traces it.
#pragma once

#include "common/cli/input_files.h"

#include "rtcore/io/import/model_import.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/kernels/ray_tracer.h"

#include <filesystem>
#include <memory>

namespace rtserver {

/// Stays where it is: the player refers to its tree and its mesh.
class World {
  public:
    World(rtcore::LoadedScene scene, std::filesystem::path path, const rtcore::ImportOptions& options)
        : loaded(std::move(scene)),
          tracer(std::make_shared<const rtcore::KdRayTracer>(loaded.tree, loaded.scene.model.mesh,
                                                             chooseLeafRecords(loaded.tree, 0))),
          source(std::move(path)), import(options) {
        inputs.add(loaded.files);
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    rtcore::LoadedScene loaded; ///< its scene as the files say; Document::scene() is what edits made of it
    /// The tracer of all that is there, hidden or not.
    std::shared_ptr<const rtcore::KdRayTracer> tracer;
    std::filesystem::path source; ///< what the user named
    rtcore::ImportOptions import; ///< as far as the user gave them
    app::InputFiles inputs;       ///< what was read
};

} // namespace rtserver

/// A scene that is loaded and can be traced.
#pragma once

#include "common/cli/input_files.h"

#include "rtcore/io/import/model_import.h"
#include "rtcore/io/scene_loader.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/shading/light/shadow_maps.h"

#include <filesystem>
#include <memory>

namespace rtserver {

/// Stays where it is: the tracer refers to the scene.
class World {
  public:
    World(rtcore::LoadedScene scene, std::filesystem::path path, const rtcore::ImportOptions& options)
        : loaded(std::move(scene)), tracer(std::make_unique<rtcore::KdRayTracer>(
                                        loaded.tree, loaded.scene.mesh(), chooseLeafRecords(loaded.tree, 0))),
          source(std::move(path)), import(options) {
        inputs.add(loaded.files);
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    rtcore::LoadedScene loaded;
    std::unique_ptr<rtcore::KdRayTracer> tracer;
    std::unique_ptr<const rtcore::ShadowMaps> shadowMaps; ///< null until they are made, where they are needed
    std::filesystem::path source;                         ///< what the user named
    rtcore::ImportOptions import;                         ///< as far as the user gave them
    app::InputFiles inputs;                               ///< what was read
};

} // namespace rtserver

#include "rtserver/document/opening.h"

#include "common/settings/settings_merge.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/set.h"
#include "rtcore/platform/sentence.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

/// Empty: none says where to look from.
std::filesystem::path cameraPathOf(const World& world, const Options& options, bool first) {
    if (first && options.camera) return *options.camera;
    const auto& file = world.loaded.sceneFile;
    return file && file->cameraFile ? *file->cameraFile : std::filesystem::path();
}

rtcore::RenderSettings settingsOf(const World& world, const Options& options,
                                  const rtcore::CameraFile* camera) {
    std::vector<rtcore::SettingAssignment> file;
    if (options.settingsFile) file = rtcore::readSettingsFile(*options.settingsFile).live;
    return app::mergeSettings({.scene = world.loaded.live,
                               .settingsFile = file,
                               .camera = camera,
                               .commandLine = options.settings});
}

} // namespace

Opening openingOf(World& world, const Options& options, const rtcore::RenderSettings* last) {
    const bool first = last == nullptr;
    rtcore::LoadedScene& loaded = world.loaded;
    rtcore::numberLights(loaded.scene);
    rtcore::Scene scene = loaded.scene;
    rtcore::useGuesses(scene, loaded.guesses);
    std::optional<rtcore::CameraFile> camera;
    const std::filesystem::path path = cameraPathOf(world, options, first);
    if (!path.empty()) camera = rtcore::readCameraFile(path, scene.origin);
    rtcore::RenderSettings settings = settingsOf(world, options, camera ? &*camera : nullptr);
    VariantBook variants = takeVariants(loaded.sceneFile, scene, settings);
    if (camera) {
        const rtcore::Sentence warning = app::applyCameraToScene(*camera, path, scene);
        if (!warning.empty()) loaded.warnings.push_back(warning);
        loaded.camera = camera->camera;
    }
    if (first) {
        app::selectParts(options.selection, scene);
        app::cutOpen(options.selection.sections, scene);
        app::selectLights(options.selection, scene);
    }
    // A .bsp may have one that Document::setCamera() refuses.
    if (rtcore::areParallel(loaded.camera.forward, loaded.camera.up))
        loaded.camera.up = rtcore::upwardsOf(loaded.camera.forward, scene.up);
    if (last != nullptr) {
        settings.width = last->width;
        settings.height = last->height;
    }
    if (variants.all.empty()) variants.base = variantScene(scene, settings);
    return {std::move(scene), settings, std::move(variants)};
}

} // namespace rtserver

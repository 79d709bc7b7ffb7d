#include "rtcore/io/scene_loader.h"

#include "rtcore/io/loading/first_camera.h"
#include "rtcore/io/loading/first_light.h"
#include "rtcore/io/loading/lighting_choice.h"
#include "rtcore/io/loading/model_reading.h"
#include "rtcore/io/loading/scene_reading.h"
#include "rtcore/scene/closed_surfaces.h"

#include <utility>

namespace rtcore {

namespace {

void readAll(Loading& loading, const std::filesystem::path& path) {
    InputFile file(path);
    const FileKind kind = kindOfFile(path, file);
    if (kind == FileKind::Scene) return readDescribed(loading, path);
    readModel(loading, path, std::move(file), kind, loading.options.import);
    Scene& scene = loading.out.scene;
    takeModelLights(scene);
    scene.background = kPlainBackground;
    scene.ambient = kPlainAmbient;
}

} // namespace

LoadedScene loadScene(const std::filesystem::path& path, const LoadOptions& options) {
    Loading loading(options);
    loading.begin(LoadPhase::ReadingScene);
    loading.out.files.push_back(path);
    readAll(loading, path);
    decideModelUnits(loading);
    chooseCamera(loading);
    takeLightingOptions(loading);
    giveLight(loading);
    Scene& scene = loading.out.scene;
    if (!loading.out.sceneFile) loading.out.guesses = guessMaterials(scene);
    numberLights(scene);
    scene.closed = findClosedSurfaces(scene.model, scene.materials, loading.out.openGlass);
    scene.solids = findGlassSolids(scene.model.mesh, scene.materials, scene.closed);
    loading.begin(LoadPhase::Done);
    return std::move(loading.out);
}

} // namespace rtcore

#include "rtcore/io/scene_loader.h"

#include "rtcore/sky/scene_sky.h"
#include "rtcore/survey/default_view.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace rtcore {

namespace {

PresetLighting lightingOfPreset(const LoadedScene& loaded, const Scene& scene) {
    // A sky by date stands wherever its place is.
    const std::optional<Sky> sky = scene.sky && scene.sky->date ? scene.sky : std::nullopt;
    const Mesh& mesh = scene.model.mesh;
    const Survey found = survey(loaded.tree, mesh, axesOf(scene));
    return presetLighting(*loaded.preset, loaded.tree, mesh, found, loaded.camera, sky);
}

bool isLitByItsPreset(const LoadedScene& loaded, const Scene& scene) {
    return loaded.preset && isLitBy(scene, lightingOfPreset(loaded, scene));
}

/// Lights that are switched off stay so.
void lightAnew(const LoadedScene& loaded, Scene& scene) {
    PresetLighting look = lightingOfPreset(loaded, scene);
    look.background = scene.background;
    look.ambient = scene.ambient;
    const std::vector<SceneLight> before = scene.lights;
    const int environment = scene.activeEnvironment;
    lightBy(scene, look);
    scene.activeEnvironment = environment;
    if (scene.lights.size() != before.size()) return;
    for (std::size_t i = 0; i < before.size(); ++i) scene.lights[i].light.on = before[i].light.on;
}

} // namespace

void applyModelUnits(LoadedScene& loaded, const ModelUnits& units, Scene& scene, Camera& camera) {
    const bool turned = units.up != scene.up;
    const bool lit = turned && isLitByItsPreset(loaded, scene);
    loaded.units = units;
    scene.up = units.up;
    scene.metresPerUnit = units.metresPerUnit;
    if (!turned) return;
    straightenSky(scene);
    if (loaded.ownCamera) {
        camera.up = upwardsOf(camera.forward, units.up);
    } else {
        const Mesh& mesh = scene.model.mesh;
        camera = loaded.camera = defaultCamera(loaded.tree, mesh, survey(loaded.tree, mesh, axesOf(scene)));
    }
    if (lit) lightAnew(loaded, scene);
}

} // namespace rtcore

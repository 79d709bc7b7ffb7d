#include "rtcore/io/scene_loader.h"

#include "rtcore/sky/scene_sky.h"
#include "rtcore/survey/default_view.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace rtcore {

namespace {

LookLights lightsOfLook(const LoadedScene& loaded, const Scene& scene) {
    // A sky by date stands wherever its place is.
    const std::optional<Sky> sky = scene.sky && scene.sky->date ? scene.sky : std::nullopt;
    const Mesh& mesh = scene.model.mesh;
    const Survey found = survey(loaded.tree, mesh, axesOf(scene));
    return lookLights(*loaded.look, loaded.tree, mesh, found, loaded.camera, sky);
}

bool isLitByItsLook(const LoadedScene& loaded, const Scene& scene) {
    return loaded.look && isLitBy(scene, lightsOfLook(loaded, scene));
}

/// Lights that are switched off stay so.
void lightAnew(const LoadedScene& loaded, Scene& scene) {
    LookLights look = lightsOfLook(loaded, scene);
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

void reframe(LoadedScene& loaded, const UpAndUnit& frame, Scene& scene, Camera& camera) {
    const bool turned = frame.up != scene.up;
    const bool lit = turned && isLitByItsLook(loaded, scene);
    loaded.frame = frame;
    scene.up = frame.up;
    scene.metresPerUnit = frame.metresPerUnit;
    if (!turned) return;
    straightenSky(scene);
    if (loaded.ownCamera) {
        camera.up = upwardsOf(camera.forward, frame.up);
    } else {
        const Mesh& mesh = scene.model.mesh;
        camera = loaded.camera = defaultCamera(loaded.tree, mesh, survey(loaded.tree, mesh, axesOf(scene)));
    }
    if (lit) lightAnew(loaded, scene);
}

} // namespace rtcore

#include "rtserver/exports.h"

#include "rtcore/settings/settings_table.h"

namespace rtserver {

namespace {

// A model by itself has what the loader gives it.
rtcore::SceneFile descriptionOf(const World& world) {
    if (world.loaded.sceneFile) return *world.loaded.sceneFile;
    rtcore::SceneFile file;
    file.creaseAngle = world.import.creaseAngle.value_or(rtcore::kCreaseAngle);
    file.flipTextures = world.import.flipTextures.value_or(false);
    return file;
}

} // namespace

rtcore::CameraFile cameraFileOf(const ServerState& state, float exposure) {
    const rtcore::Scene& scene = *state.scene();
    const rtcore::RenderSettings& settings = state.settings();
    rtcore::CameraFile file;
    file.camera = state.camera();
    file.camera.nameOffset = 0;
    file.width = settings.width;
    file.height = settings.height;
    file.antialiasing = settings.antialiasing;
    file.bloom = settings.bloom.radius;
    file.exposure = exposure;
    file.lights.emplace();
    for (const rtcore::Light& light : scene.lights) file.lights->push_back(light.on != 0);
    if (!scene.environments.empty()) file.environment = scene.activeEnvironment;
    return file;
}

rtcore::SceneFile sceneFileOf(const ServerState& state) {
    const World& world = state.world();
    const rtcore::Scene& scene = *state.scene();
    rtcore::SceneFile file = descriptionOf(world);
    file.model = world.loaded.modelPath;
    static_cast<rtcore::SceneLook&>(file) = scene;
    if (scene.environments.empty()) file.activeEnvironment = 0;
    file.metresPerUnit = state.metresPerUnit(); // guessed where the scene does not say
    if (world.import.creaseAngle) file.creaseAngle = *world.import.creaseAngle;
    if (world.import.flipTextures) file.flipTextures = *world.import.flipTextures;
    file.settings.reset();
    file.output.reset(); // a copy of a scene does not overwrite the image of the first
    file.modelLights = false;
    file.lights.clear();
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        rtcore::LightDescription light{i < scene.lightNames.size() ? scene.lightNames[i] : "",
                                       scene.lights[i]};
        light.light.nameOffset = 0;
        file.lights.push_back(std::move(light));
    }
    file.cameraFile.reset();
    file.camera = state.camera();
    file.camera->nameOffset = 0;
    file.live = rtcore::settingAssignments(state.settings(), true);
    file.still = file.live;
    return file;
}

} // namespace rtserver

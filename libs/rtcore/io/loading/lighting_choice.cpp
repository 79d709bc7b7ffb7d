#include "rtcore/io/loading/lighting_choice.h"

#include "rtcore/io/images/environment_file.h"
#include "rtcore/sky/scene_sky.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace rtcore {

namespace {

/// The light of the .scn that is its sun, as it was edited.
std::optional<std::size_t> editedSun(const Loading& loading) {
    if (!loading.describedSky || loading.out.sceneFile->sun.id == 0) return std::nullopt;
    const auto light = lightWithId(loading.out.scene, loading.out.sceneFile->sun.id);
    const bool fits = light && loading.out.scene.lights[*light].light.kind == LightKind::Directional;
    return fits ? light : std::nullopt;
}

void setSun(Scene& scene, const SunDescription& sun, std::optional<std::size_t> edited) {
    if (edited) return replaceSun(scene, *edited);
    if (!sunOf(scene)) return;
    SceneLight& own = scene.lights[*sunOf(scene)];
    own.light.on = sun.on ? 1 : 0;
    if (sun.id > 0 && !lightWithId(scene, sun.id)) own.notes.id = sun.id;
}

} // namespace

void takeLightingOptions(Loading& loading) {
    Scene& scene = loading.out.scene;
    const LightingOptions& wanted = loading.options.lighting;
    const int active = scene.activeEnvironment;
    auto edited = editedSun(loading);
    if (edited && (wanted.environment || wanted.sky)) {
        eraseLight(scene, *edited); // it goes with the sky of the file
        edited.reset();
    }
    if (wanted.environment) {
        loading.begin(LoadPhase::LoadingImages);
        OpenedEnvironment opened = openEnvironment(*wanted.environment);
        loading.addFile(opened.file, std::move(opened.environment));
        scene.activeEnvironment = static_cast<int>(scene.environments.size()) - 1;
    } else if (wanted.sky || loading.describedSky) {
        setSky(scene, wanted.sky ? wanted.sky : loading.describedSky);
        if (loading.describedSky) setSun(scene, loading.out.sceneFile->sun, edited);
        if (!wanted.sky) scene.activeEnvironment = active;
    }
}

} // namespace rtcore

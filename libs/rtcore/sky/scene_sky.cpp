#include "rtcore/sky/scene_sky.h"

#include "rtcore/sky/sky_light.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

/// Any light may be called that: SceneLight::ofSky tells which one the sky sets.
constexpr const char* kSunName = "sun";

/// Copies of scenes share environments.
template <typename Change>
void changeEnvironment(Scene& scene, std::size_t i, Change change) {
    Environment changed = *scene.environments[i];
    change(changed);
    scene.environments[i] = std::make_shared<const Environment>(std::move(changed));
}

void removeSky(Scene& scene) {
    if (const auto sun = sunOf(scene)) eraseLight(scene, *sun);
    scene.environments.pop_back();
    if (std::cmp_equal(scene.activeEnvironment, scene.environments.size())) scene.activeEnvironment = 0;
    scene.sky.reset();
}

void giveGround(Scene& scene, const Sky& sky) {
    const Colour albedo = kWhite * groundAlbedo(sky);
    const GroundEdge edge = sky.studio ? GroundEdge::Fades : GroundEdge::Far;
    if (!scene.ground || scene.ground->up != scene.up || scene.ground->material.diffuse != albedo ||
        scene.ground->edge != edge)
        scene.ground = makeGround(scene.model, scene.up, albedo, edge);
}

void addSun(Scene& scene, const Light& sun) {
    scene.lights.emplace_back(sun, kSunName).ofSky = true;
    numberLights(scene);
}

void addSky(Scene& scene, const Sky& sky) {
    SkyLight made = skyLightOf(sky, scene.up);
    scene.activeEnvironment = static_cast<int>(scene.environments.size());
    scene.environments.push_back(std::move(made.environment));
    if (made.sun) addSun(scene, *made.sun);
    scene.sky = sky;
}

} // namespace

void setSky(Scene& scene, const std::optional<Sky>& sky) {
    if (sky && sky->ground) giveGround(scene, *sky);
    if (!scene.sky && sky) return addSky(scene, *sky);
    if (scene.sky && !sky) return removeSky(scene);
    if (!sky) return;
    SkyLight made = skyLightOf(*sky, scene.up);
    scene.environments.back() = std::move(made.environment);
    if (const auto sun = sunOf(scene); sun && !made.sun) {
        eraseLight(scene, *sun);
    } else if (sun) {
        SceneLight& last = scene.lights[*sun];
        made.sun->on = last.light.on;
        last.light = *made.sun;
        last.notes = {.id = last.notes.id};
    } else if (made.sun && scene.sky->studio) {
        addSun(scene, *made.sun);
    }
    scene.sky = sky;
}

std::optional<std::size_t> skyEnvironmentOf(const Scene& scene) {
    return scene.sky ? std::optional(scene.fileEnvironments()) : std::nullopt;
}

std::optional<std::size_t> sunOf(const Scene& scene) {
    if (!scene.sky) return std::nullopt;
    const auto sun = std::ranges::find(scene.lights, true, &SceneLight::ofSky);
    if (sun == scene.lights.end()) return std::nullopt;
    return static_cast<std::size_t>(sun - scene.lights.begin());
}

bool isSunEdited(const Scene& scene) {
    const auto sun = sunOf(scene);
    if (!sun) return false;
    Light made = sunOfSky(*scene.sky, scene.up);
    const SceneLight& now = scene.lights[*sun];
    made.on = now.light.on;
    return now.light != made || now.notes.temperature > 0;
}

void replaceSun(Scene& scene, std::size_t light) {
    const auto own = sunOf(scene);
    numberLights(scene);
    scene.lights[light].ofSky = true;
    if (own && *own != light) eraseLight(scene, *own);
    moveSunBehind(scene);
}

std::shared_ptr<const Scene> withoutSkyMap(const std::shared_ptr<const Scene>& scene) {
    if (!scene->sky || scene->environments.back() == nullptr) return scene;
    Scene light = *scene;
    light.environments.back().reset();
    return std::make_shared<const Scene>(std::move(light));
}

Scene withSkyMap(const Scene& scene, const Scene* like) {
    Scene whole = scene;
    if (!whole.sky || whole.environments.back() != nullptr) return whole;
    const bool same = like != nullptr && like->sky == whole.sky && like->up == whole.up;
    whole.environments.back() =
        same ? like->environments.back() : skyLightOf(*whole.sky, whole.up).environment;
    return whole;
}

void moveSunBehind(Scene& scene) {
    const auto sun = sunOf(scene);
    if (!sun) return;
    numberLights(scene);
    const auto from = scene.lights.begin() + static_cast<std::ptrdiff_t>(*sun);
    std::rotate(from, from + 1, scene.lights.end());
}

std::size_t addEnvironment(Scene& scene, const EnvironmentFile& file, Environment environment) {
    const std::size_t i = scene.fileEnvironments();
    environment.intensity = file.intensity;
    environment.turn(file.rotation, scene.up);
    scene.environmentFiles.resize(i);
    scene.environmentFiles.push_back(file);
    scene.environments.insert(scene.environments.begin() + static_cast<std::ptrdiff_t>(i),
                              std::make_shared<const Environment>(std::move(environment)));
    if (scene.sky && std::cmp_equal(scene.activeEnvironment, i)) ++scene.activeEnvironment;
    return i;
}

void setEnvironmentIntensity(Scene& scene, std::size_t environment, float intensity) {
    scene.environmentFiles.at(environment).intensity = intensity;
    changeEnvironment(scene, environment, [&](Environment& e) { e.intensity = intensity; });
}

void setEnvironmentRotation(Scene& scene, std::size_t environment, float degrees) {
    scene.environmentFiles.at(environment).rotation = degrees;
    changeEnvironment(scene, environment, [&](Environment& e) { e.turn(degrees, scene.up); });
}

void straightenSky(Scene& scene) {
    for (std::size_t i = 0; i < scene.fileEnvironments(); ++i) {
        if (const float rotation = scene.environments[i]->rotation(); rotation != 0)
            changeEnvironment(scene, i, [&](Environment& e) { e.turn(rotation, scene.up); });
    }
    if (scene.sky) setSky(scene, Sky(*scene.sky));
}

} // namespace rtcore

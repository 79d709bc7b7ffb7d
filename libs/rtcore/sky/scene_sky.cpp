#include "rtcore/sky/scene_sky.h"

#include "rtcore/sky/sky_light.h"

#include <algorithm>
#include <utility>

namespace rtcore {

namespace {

std::size_t filesOf(const Scene& scene) { return scene.environments.size() - (scene.sky ? 1 : 0); }

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
    scene.lightNames.resize(scene.lights.size());
    scene.lights.push_back(sun);
    scene.lightNames.emplace_back(kSunName);
    numberLights(scene);
    scene.lightNotes.back().ofSky = true;
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
        made.sun->on = scene.lights[*sun].on;
        scene.lights[*sun] = *made.sun;
        scene.lightNotes[*sun] = {.id = scene.lightNotes[*sun].id, .ofSky = true};
    } else if (made.sun && scene.sky->studio) {
        addSun(scene, *made.sun);
    }
    scene.sky = sky;
}

std::optional<std::size_t> skyEnvironmentOf(const Scene& scene) {
    return scene.sky ? std::optional(scene.environments.size() - 1) : std::nullopt;
}

std::optional<std::size_t> sunOf(const Scene& scene) {
    if (!scene.sky) return std::nullopt;
    const auto sun = std::ranges::find(scene.lightNotes, true, &LightNotes::ofSky);
    if (sun == scene.lightNotes.end()) return std::nullopt;
    return static_cast<std::size_t>(sun - scene.lightNotes.begin());
}

bool isSunEdited(const Scene& scene) {
    const auto sun = sunOf(scene);
    if (!sun) return false;
    Light made = sunOfSky(*scene.sky, scene.up);
    made.on = scene.lights[*sun].on;
    return scene.lights[*sun] != made || scene.lightNotes[*sun].temperature > 0;
}

void replaceSun(Scene& scene, std::size_t light) {
    const auto own = sunOf(scene);
    numberLights(scene);
    scene.lightNotes[light].ofSky = true;
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
    const auto turn = [from = static_cast<std::ptrdiff_t>(*sun)](auto& all) {
        std::rotate(all.begin() + from, all.begin() + from + 1, all.end());
    };
    numberLights(scene);
    turn(scene.lights);
    turn(scene.lightNames);
    turn(scene.lightNotes);
}

std::size_t addEnvironment(Scene& scene, const EnvironmentFile& file, Environment environment) {
    const std::size_t i = filesOf(scene);
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
    for (std::size_t i = 0; i < filesOf(scene); ++i) {
        if (const float rotation = scene.environments[i]->rotation(); rotation != 0)
            changeEnvironment(scene, i, [&](Environment& e) { e.turn(rotation, scene.up); });
    }
    if (scene.sky) setSky(scene, Sky(*scene.sky));
}

} // namespace rtcore

#include "rtcore/look/light_units.h"

#include "rtcore/look/lighting_preset.h"
#include "rtcore/settings/plain_text.h"
#include "rtcore/sky/scene_sky.h"
#include "rtcore/sky/sky_light.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rtcore {

namespace {

bool isClearSky(const Scene& scene) { return scene.sky && !scene.sky->studio; }

/// Whether the environment is the computed sky's.
bool showsSky(const Scene& scene) {
    const auto own = skyEnvironmentOf(scene);
    return isClearSky(scene) && std::cmp_equal(scene.activeEnvironment, *own);
}

bool isOfSky(const Scene& scene, const SceneLight& light) { return light.ofSky && isClearSky(scene); }
bool shines(const SceneLight& each) { return each.light.on != 0 && !isBlack(each.light.intensity); }

void leaveLights(Scene& scene, bool ofSky) {
    std::erase_if(scene.lights, [&](const SceneLight& each) { return isOfSky(scene, each) != ofSky; });
}

void darkenSurroundings(Scene& scene) {
    scene.activeEnvironment = kNoEnvironment;
    scene.background = scene.ambient = {};
}

Scene skyAlone(const Scene& scene) {
    Scene sky = scene;
    leaveLights(sky, true);
    for (Material& material : sky.materials) material.emission = {};
    sky.fog.colour = sky.fog.emission = {};
    if (showsSky(scene))
        sky.background = sky.ambient = {};
    else
        darkenSurroundings(sky);
    return sky;
}

Scene withoutSky(const Scene& scene) {
    Scene rest = scene;
    leaveLights(rest, false);
    if (showsSky(scene)) darkenSurroundings(rest);
    return rest;
}

bool shinesSky(const Scene& scene) {
    const auto sun = isClearSky(scene) ? sunOf(scene) : std::nullopt;
    return showsSky(scene) || (sun && shines(scene.lights[*sun]));
}

bool emitsLight(const Material& material) { return !isBlack(material.emission); }

bool hasBrightFog(const Scene& scene) {
    const Fog& fog = scene.fog;
    return fog.kind != FogKind::None && fog.density > 0 && !(isBlack(fog.colour) && isBlack(fog.emission));
}

bool hasLight(const Scene& scene) {
    return std::ranges::any_of(scene.lights, shines) || std::ranges::any_of(scene.materials, emitsLight) ||
           scene.environment() != nullptr || !isBlack(scene.background) || !isBlack(scene.ambient) ||
           hasBrightFog(scene);
}

// --- What has no unit ---

Sentence nameOf(const Environment& environment) {
    return environment.name().empty() ? say("an environment")
                                      : say("the environment {0}", printable(environment.name()));
}

void addSurroundings(const Scene& scene, std::vector<Sentence>& what) {
    if (const Environment* const environment = scene.environment()) {
        if (!showsSky(scene)) what.push_back(nameOf(*environment));
    } else if (!isBlack(scene.background)) {
        what.push_back(say("the background"));
    } else if (!isBlack(scene.ambient)) {
        what.push_back(say("ambient light"));
    }
}

/// Which materials that emit are in use.
std::vector<std::size_t> usedEmitters(const Scene& scene) {
    std::vector<std::uint8_t> used(scene.materials.size());
    for (const ShadingTriangle& each : scene.model.mesh.shading)
        if (each.material < used.size()) used[each.material] = 1;
    std::vector<std::size_t> emitters;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i] != 0 && emitsLight(scene.materials[i])) emitters.push_back(i);
    return emitters;
}

bool isOfModel(const Scene& scene, std::size_t material) {
    return material < scene.model.materials.size() &&
           scene.model.materials[material].emission == scene.materials[material].emission;
}

bool isOfModel(const Scene& scene, const SceneLight& each) {
    Light light = each.light;
    return std::ranges::any_of(scene.model.lights, [&](const Light& own) {
        light.nameOffset = own.nameOffset;
        light.on = own.on;
        return light == own;
    });
}

enum class UnitOfLight { Watts, Preset, File };

UnitOfLight unitOf(const Scene& scene, const SceneLight& each) {
    if (each.light.kind == LightKind::Ies) return UnitOfLight::Watts;
    if (isPresetLightName(each.name)) return UnitOfLight::Preset;
    return isOfModel(scene, each) ? UnitOfLight::File : UnitOfLight::Watts;
}

/// Returns whether some have a unit.
bool addLights(const Scene& scene, std::vector<Sentence>& what) {
    bool some = false, preset = false, file = false;
    for (const SceneLight& each : scene.lights) {
        if (!shines(each) || isOfSky(scene, each)) continue;
        const UnitOfLight unit = unitOf(scene, each);
        some = some || unit == UnitOfLight::Watts;
        preset = preset || unit == UnitOfLight::Preset;
        file = file || unit == UnitOfLight::File;
    }
    if (preset) what.push_back(say("lights of a look"));
    if (file) what.push_back(say("lights as the model's file brought them"));
    return some;
}

/// Returns whether there is some that has a unit.
bool addSky(const Scene& scene, std::vector<Sentence>& what) {
    const auto sun = isClearSky(scene) ? sunOf(scene) : std::nullopt;
    const bool sunny = sun && shines(scene.lights[*sun]);
    if (!sunny && !showsSky(scene)) return false;
    if (scene.sky->strength != 1) what.push_back(say("a sky of another strength than 1"));
    if (sunny && isSunEdited(scene)) what.push_back(say("a sun that was edited"));
    return true;
}

bool addEmission(const Scene& scene, std::vector<Sentence>& what) {
    const std::vector<std::size_t> emitters = usedEmitters(scene);
    const auto ofModel = static_cast<std::size_t>(
        std::ranges::count_if(emitters, [&](std::size_t i) { return isOfModel(scene, i); }));
    if (ofModel > 0) what.push_back(say("surfaces that emit as the model's file says"));
    return ofModel < emitters.size();
}

} // namespace

LightByUnit lightByUnit(const Scene& scene) {
    LightByUnit light;
    if (shinesSky(scene)) light.sky = LightOfUnit{skyAlone(scene), double{kLuminanceOfOne}};
    Scene rest = withoutSky(scene);
    if (hasLight(rest)) light.rest = LightOfUnit{std::move(rest)};
    return light;
}

std::optional<Scene> inUnitOfSky(const Scene& scene) {
    if (!shinesSky(scene) || !hasLight(withoutSky(scene))) return std::nullopt;
    const auto factor = static_cast<float>(kLumensPerWatt / double{kLuminanceOfOne});
    std::optional<Scene> result = scene;
    for (SceneLight& each : result->lights)
        if (!isOfSky(scene, each)) each.light.intensity = each.light.intensity * factor;
    for (Material& material : result->materials) material.emission = material.emission * factor;
    result->fog.colour = result->fog.colour * factor;
    result->fog.emission = result->fog.emission * factor;
    if (!showsSky(scene)) {
        result->background = result->background * factor;
        result->ambient = result->ambient * factor;
    }
    return result;
}

UnitlessLight unitlessLight(const Scene& scene, const RenderSettings& settings) {
    UnitlessLight light;
    const bool sky = addSky(scene, light.what), lights = addLights(scene, light.what),
               emission = addEmission(scene, light.what);
    addSurroundings(scene, light.what);
    if (settings.fog.on && hasBrightFog(scene)) light.what.push_back(say("fog"));
    light.all = !light.what.empty() && !sky && !lights && !emission;
    return light;
}

LuminanceUnit unitOfImages(const Scene& scene, const RenderSettings& settings) {
    return {.ofOne = shinesSky(scene) ? kLuminanceOfOne : static_cast<float>(kLumensPerWatt),
            .absolute = !unitlessLight(scene, settings).all};
}

Sentence unitWarning(const UnitlessLight& light) {
    if (light.what.empty()) return {};
    if (light.all)
        return say("the light of this scene has no absolute unit ({0}), so that false colours tell what is "
                   "brighter than what, but no cd/m2 or lux",
                   light.what.front());
    return say(
        "some of the light of this scene has no absolute unit ({0}), so that false colours are true of "
        "the rest alone",
        light.what.front());
}

} // namespace rtcore

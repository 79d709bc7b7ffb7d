#include "rtcore/look/lighting_preset.h"

#include "rtcore/look/room_lights.h"
#include "rtcore/look/sun_of_view.h"
#include "rtcore/look/visible_points.h"
#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"
#include "rtcore/sky/scene_sky.h"
#include "rtcore/survey/default_view.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace rtcore {

namespace {

constexpr int kFilterPasses = 4;        ///< of images by paths
constexpr float kContrast = 2;          ///< of film: with its own, colours are pale where white is near 240
constexpr float kRoomBackground = 1.2F; ///< nearly white beside what the lights show
/// Reach of ambient occlusion: metres, or a fraction of the model's diagonal.
constexpr float kReach = 5, kReachOfDiagonal = 0.15F;

/// One of the lights around an object: where from, as seen by the viewer, and how bright.
struct StudioLight {
    const char* name;
    float left, high; ///< degrees: to the viewer's left of where he stands, over the horizon
    float size;       ///< side of a square, in radii of the object
    float irradiance; ///< in the middle of the object
};
constexpr StudioLight kStudioLights[] = {
    {"key", 45, 45, 2.2F, 2.5F}, {"fill", -60, 20, 2.4F, 0.6F}, {"rim", -160, 50, 1.8F, 1.5F}};
constexpr float kStudioDistance = 3;                  ///< radii
constexpr std::string_view kCeilingName = "ceiling "; ///< and a number

float cosineOf(float degrees) { return portableCos(degrees * (kPi / 180)); }
float sineOf(float degrees) { return portableSin(degrees * (kPi / 180)); }

/// A rectangle that shines at the middle of the object.
Light studioLight(const StudioLight& each, const Box3& bounds, Vec3 up, Vec3 back) {
    const Vec3 left = cross(back, up);
    const Vec3 level = back * cosineOf(each.left) + left * sineOf(each.left);
    const Vec3 to = normalize(level * cosineOf(each.high) + up * sineOf(each.high));
    const float radius = 0.5F * bounds.diagonal(), distance = kStudioDistance * radius;
    Light light;
    light.kind = LightKind::Rectangle;
    light.position = bounds.centre() + to * distance;
    light.direction = -to;
    light.right = normalize(cross(light.direction, up));
    light.width = light.height = each.size * radius;
    light.intensity = kWhite * (each.irradiance * distance * distance);
    light.mirrored = 1;
    return light;
}

void addStudioLights(PresetLighting& preset, const Box3& bounds, Vec3 up, Vec3 forward) {
    const Vec3 level = forward - up * dot(forward, up);
    const Vec3 side = up.x == 0 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 back = length(level) > 1e-3F * length(forward) ? -normalize(level) : side;
    for (const StudioLight& each : kStudioLights)
        preset.lights.emplace_back(studioLight(each, bounds, up, back), each.name);
}

std::vector<SceneLight> namedRoomLights(const KdTree& tree, const Mesh& mesh, const Survey& survey) {
    std::vector<SceneLight> lights;
    for (const Light& light : roomLights(tree, mesh, survey))
        lights.emplace_back(light, std::string(kCeilingName) + std::to_string(lights.size() + 1));
    return lights;
}

Sky skyOfView(const KdTree& tree, const Mesh& mesh, const Survey& survey, const Camera& camera) {
    Sky sky{.haze = true};
    sky.date.reset();
    sky.direction = sunOfView(tree, mesh, survey, camera);
    return sky;
}

/// How an image is exposed, and what is made of it.
std::vector<SettingAssignment> exposureBy(const char* mode, const char* toneMapping, float contrast,
                                          int filterPasses) {
    return {{"exposure.mode", mode},
            {"toneMapping", toneMapping},
            {"toneContrast", contrast},
            {"path.filter", filterPasses}};
}

std::vector<SettingAssignment> trueLight(std::vector<SettingAssignment> exposure) {
    exposure.push_back({"indirect.mode", "live"});
    return exposure;
}

} // namespace

std::optional<LightingPreset> lightingPresetNamed(std::string_view name) {
    const auto found = std::find(kLightingPresetNames.begin(), kLightingPresetNames.end(), name);
    if (found == kLightingPresetNames.end()) return std::nullopt;
    return static_cast<LightingPreset>(found - kLightingPresetNames.begin());
}

bool isPresetLightName(std::string_view name) {
    const auto isName = [&](const StudioLight& each) { return name == each.name; };
    return name == kHeadlightName || name.starts_with(kCeilingName) ||
           std::ranges::any_of(kStudioLights, isName);
}

bool wantsGround(const Mesh& mesh, const Survey& survey) {
    constexpr std::size_t kMaxTriangles = 10'000'000;
    if (survey.subject.bounds.empty() || mesh.triangles.size() > kMaxTriangles) return false;
    return !survey.inside() && !survey.isStage() && !survey.subject.ground;
}

PresetLighting presetLighting(LightingPreset preset, const KdTree& tree, const Mesh& mesh,
                              const Survey& survey, const Camera& camera, const std::optional<Sky>& sky) {
    PresetLighting result;
    switch (preset) {
    case LightingPreset::Sky:
        result.sky = sky ? *sky : skyOfView(tree, mesh, survey, camera);
        result.lights = namedRoomLights(tree, mesh, survey);
        result.sky->ground = wantsGround(mesh, survey);
        break;
    case LightingPreset::Studio:
        result.lights = namedRoomLights(tree, mesh, survey);
        if (result.lights.empty()) {
            result.sky = Sky{.ground = wantsGround(mesh, survey), .studio = true};
            addStudioLights(result, survey.subject.bounds, survey.axes.up, camera.forward);
        } else {
            result.background = kWhite * kRoomBackground;
        }
        break;
    case LightingPreset::Headlight:
        result.lights.emplace_back(defaultLight(camera, tree.bounds), kHeadlightName);
        break;
    }
    return result;
}

void lightBy(Scene& scene, const PresetLighting& preset) {
    setSky(scene, std::nullopt);
    scene.activeEnvironment = scene.environments.empty() ? 0 : kNoEnvironment;
    scene.background = preset.background;
    scene.ambient = preset.ambient;
    scene.lights = preset.lights;
    setSky(scene, preset.sky);
    numberLights(scene);
}

// Light that surfaces send to each other reaches what the sky does not: no room that one walks into is black.
std::vector<SettingAssignment> settingsOf(LightingPreset preset, const Survey& survey) {
    std::vector<SettingAssignment> settings = settingsOf(preset);
    if (preset == LightingPreset::Headlight) {
        settings.insert(settings.end(),
                        {{"indirect.mode", "off"}, {"skyLight.on", false}, {"ambientOcclusion.on", false}});
        return settings;
    }
    // The diagonal of the subject: wide ground does not make its rooms dark.
    const float diagonal = survey.subject.bounds.diagonal();
    const float reach = std::min(kReachOfDiagonal * diagonal, kReach * survey.axes.metre);
    settings.insert(
        settings.end(),
        {{"skyLight.on", true}, {"ambientOcclusion.on", true}, {"ambientOcclusion.distance", reach}});
    return settings;
}

// Out of doors and in rooms there is a wide range of light, for which film is made; an object in a studio
// keeps its colours.
std::vector<SettingAssignment> settingsOf(LightingPreset preset) {
    switch (preset) {
    case LightingPreset::Sky:
        return trueLight(exposureBy("incident", "agx", kContrast, kFilterPasses));
    case LightingPreset::Studio:
        return trueLight(exposureBy("incident", "neutral", 0, kFilterPasses));
    case LightingPreset::Headlight:
        break;
    }
    return exposureBy("automatic", "luminance", 0, 0);
}

bool isLitBy(const Scene& scene, const PresetLighting& preset) {
    std::vector<Light> lights = lightsOf(scene.lights);
    if (const auto sun = sunOf(scene)) lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(*sun));
    for (Light& light : lights) light.on = 1;
    return lights == lightsOf(preset.lights) && scene.sky == preset.sky;
}

void addHeadlight(Scene& scene, const Box3& bounds, const Camera& camera) {
    scene.lights.emplace_back(defaultLight(camera, bounds), kHeadlightName);
    numberLights(scene);
}

std::optional<Colour> fillLight(const Scene& scene, const KdTree& tree, const Camera& camera) {
    constexpr float kDark = 0.02F, kMuch = 0.03F, kFill = 0.04F; // of what is well lit or seen
    const Mesh& mesh = scene.model.mesh;
    const std::vector<VisiblePoint> points = visiblePoints(tree, mesh, camera);
    if (points.empty()) return std::nullopt;
    std::vector<float> sums = irradianceAt(tree, mesh, lightsOf(scene.lights), points);
    for (float& sum : sums) sum += kPi * maxComponent(scene.ambient);
    std::ranges::sort(sums);
    const float usual = sums[sums.size() * 9 / 10];
    const float well = usual > 0 ? usual : sums.back();
    const auto dark = std::ranges::count_if(sums, [&](float sum) { return sum < kDark * well; });
    if (static_cast<float>(dark) < kMuch * static_cast<float>(sums.size())) return std::nullopt;
    return kWhite * (kFill * well / kPi);
}

void addRoomLights(Scene& scene, const KdTree& tree, const Survey& survey) {
    const std::vector<SceneLight> lights = namedRoomLights(tree, scene.model.mesh, survey);
    scene.lights.insert(scene.lights.end(), lights.begin(), lights.end());
    numberLights(scene);
}

} // namespace rtcore

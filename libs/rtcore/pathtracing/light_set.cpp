#include "rtcore/pathtracing/light_set.h"

#include "rtcore/kernels/section_clip.h"
#include "rtcore/math/constants.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

/// By material: the box of its emissive triangles; empty where there is none.
std::vector<Box3> boxesOfEmission(const Scene& scene) {
    const Mesh& mesh = scene.mesh();
    std::vector<Box3> boxes(scene.materials.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t material = mesh.shading[t].material;
        if (material >= boxes.size() || isBlack(scene.material(material).emission)) continue;
        for (int corner = 0; corner < 3; ++corner) boxes[material].extend(mesh.position(t, corner));
    }
    return boxes;
}

/// By material, 1 where a light of the scene stands in for its emission: one lies in the box of its
/// triangles.
std::vector<std::uint8_t> hasProxyLight(const Scene& scene) {
    constexpr float kAround = 0.05F; // of the box's largest side
    std::vector<std::uint8_t> result(scene.materials.size());
    const std::vector<Box3> boxes = boxesOfEmission(scene);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box3& box = boxes[i];
        if (box.empty()) continue;
        const Vec3 margin = Vec3{1, 1, 1} * (kAround * std::max({box.size().x, box.size().y, box.size().z}));
        const auto inside = [&](const Light& light) {
            const Vec3 p = light.position, low = box.lo - margin, high = box.hi + margin;
            return light.on != 0 && traitsOf(light).position && p.x >= low.x && p.y >= low.y &&
                   p.z >= low.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
        };
        result[i] = std::ranges::any_of(scene.lights, inside, &SceneLight::light) ? 1 : 0;
    }
    return result;
}

/// Those that are hidden, and where sections let light in those that a plane cuts, or takes away: what is
/// left of them is found by rays that hit it by chance.
std::vector<std::uint8_t> noEmitters(const Scene& scene, const Box3& bounds,
                                     std::span<const std::uint8_t> hidden) {
    std::vector<std::uint8_t> none(hidden.begin(), hidden.end());
    if (!scene.sections.letLightIn()) return none;
    const SectionClip clip(scene.sections, bounds);
    const std::vector<std::uint8_t> uncut = partTriangles(scene.model, scene.uncutParts);
    const Mesh& mesh = scene.model.mesh;
    none.resize(mesh.triangles.size());
    for (std::uint32_t t = 0; t < none.size(); ++t)
        for (int corner = 0; corner < 3 && none[t] == 0 && uncut[t] == 0; ++corner)
            none[t] = clip.removes(mesh.position(t, corner)) ? 1 : 0;
    return none;
}

} // namespace

void LightSet::prepare(const Scene& scene, const RenderSettings& settings, const Box3& bounds,
                       std::span<const std::uint8_t> hidden) {
    const EmitterLight use = settings.path.emitters;
    lights_.clear();
    discs_.clear();
    mirrored_.clear();
    anyArea_ = false;
    for (const SceneLight& each : scene.lights) {
        const Light& light = each.light;
        if (light.on == 0 || isBlack(light.intensity)) continue;
        const auto number = static_cast<std::uint32_t>(lights_.size());
        if (isDisc(light)) discs_.push_back(number);
        if (isMirrored(light)) mirrored_.push_back(number);
        anyArea_ = anyArea_ || isAreaLight(light.kind);
        lights_.push_back(light);
    }
    emitsNoLight_.assign(scene.materials.size(), use == EmitterLight::Off ? 1 : 0);
    if (use == EmitterLight::Automatic) emitsNoLight_ = hasProxyLight(scene);
    emitters_ = {};
    if (use != EmitterLight::Off) {
        const std::vector<std::uint8_t> none = noEmitters(scene, bounds, hidden);
        emitters_.prepare(scene,
                          {.hidden = none, .emitsNoLight = emitsNoLight_, .textures = settings.textures});
    }
    background_ = backgroundLight(scene, settings.environmentFilter, scene.ambient);
    surroundings_ = {};
    surroundings_.prepare(background_);
    tree_ = {};
    if (lights_.size() > kMaxWeighed) tree_.prepare(lights_, bounds);
    visibility_ = {};
}

LightRows LightSet::rows() const {
    LightRows rows;
    rows.light = lights_.data();
    rows.lights = static_cast<std::uint32_t>(lights_.size());
    rows.emitters = !emitters_.empty();
    rows.surroundings = !surroundings_.empty();
    if (!tree_.empty()) rows.tree = tree_.rows();
    rows.visible = visibility_.rows();
    if (rows.emitters) {
        rows.emitterTree = emitters_.rows().tree;
        const Vec3 size = emitters_.bounds().size();
        rows.emittersCentre = emitters_.centre();
        rows.emittersIntensity = static_cast<float>(emitters_.power() / (4 * kPi));
        rows.emittersSquare = std::max(0.25F * dot(size, size), 1e-30F);
    }
    if (rows.surroundings) rows.surroundingLight = static_cast<float>(surroundings_.scalarIrradiance() / 4);
    return rows;
}

} // namespace rtcore

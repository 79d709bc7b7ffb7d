#include "rtcore/io/import/gltf/lights.h"

#include "rtcore/io/import/gltf/node_order.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/math/constants.h"
#include "rtcore/scene/light_power.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rtcore::gltf {

namespace {

constexpr const char *kPunctual = "KHR_lights_punctual", *kIes = "EXT_lights_ies";
constexpr float kBrightest = 1e16F;

std::optional<std::size_t> punctualOf(const Json& node) { return index(extension(node, kPunctual), "light"); }
std::optional<std::size_t> luminaireOf(const Json& node) { return index(extension(node, kIes), "light"); }

std::optional<LightKind> kindOf(const Json& light) {
    const std::string type = text(light, "type");
    if (type == "point") return LightKind::Point;
    if (type == "spot") return LightKind::Spot;
    if (type == "directional") return LightKind::Directional;
    return std::nullopt;
}

Colour colourOf(const Json& object) {
    const auto rgb = numbers<3>(object, "color");
    return rgb ? Colour{(*rgb)[0], (*rgb)[1], (*rgb)[2]} : kWhite;
}

/// Soft edges of a tenth at least, so that the cone has no jagged rim.
void setCone(const Json& spot, Light& out) {
    const float inner = number(spot, "innerConeAngle", 0);
    const float outer = std::clamp(number(spot, "outerConeAngle", kPi / 4), 0.01F, kPi / 2);
    out.cosOuter = portableCos(outer);
    out.cosInner = portableCos(std::clamp(inner, 0.0F, outer * 0.9F));
}

/// Where x points to, perpendicular to the direction; any where that is flat.
Vec3 rightOf(const Affine& toWorld, Vec3 direction) {
    const Vec3 x = normalize(toWorld.vector({1, 0, 0}));
    const Vec3 right = normalize(x - direction * dot(x, direction));
    return right == Vec3{} ? basisAround(direction).tangent : right;
}

/// False where it gives no light, or stands nowhere.
bool place(const Affine& toWorld, Light& out) {
    out.position = toWorld.point({});
    if (out.kind != LightKind::Point) {
        out.direction = normalize(toWorld.vector({0, 0, -1}));
        if (out.direction == Vec3{}) return false;
    }
    if (traitsOf(out).turns()) out.right = rightOf(toWorld, out.direction);
    const Colour i = out.intensity;
    return isPlace(out.position) && i.r >= 0 && i.g >= 0 && i.b >= 0 && maxComponent(i) <= kBrightest &&
           !isBlack(i);
}

/// `perUnit`: of a candela and of a lux, in watts.
std::optional<Light> punctualLight(const Json& stated, const Affine& toWorld, float perUnit) {
    const auto kind = kindOf(stated);
    if (!kind) return std::nullopt;
    Light out;
    out.kind = *kind;
    out.intensity = colourOf(stated) * number(stated, "intensity", 1) * perUnit;
    if (out.kind == LightKind::Spot) setCone(member(stated, "spot"), out);
    return place(toWorld, out) ? std::optional(out) : std::nullopt;
}

Colour upToWhite(Colour colour) {
    const auto within = [](float each) { return std::clamp(each, 0.0F, 1.0F); };
    return {within(colour.r), within(colour.g), within(colour.b)};
}

/// Where its profile cannot be read, it is as bright as its multiplier says.
std::optional<Light> luminaireAt(const Json& node, const Affine& toWorld, Luminaires& luminaires) {
    const Json& stated = extension(node, kIes);
    const auto shape = luminaires.find(*index(stated, "light"), toWorld.determinant() < 0);
    Light out;
    out.intensity = upToWhite(colourOf(stated)) * number(stated, "multiplier", 1);
    if (shape) {
        out.kind = LightKind::Ies;
        out.photometry = shape->photometry;
        out.intensity = out.intensity * shape->intensity;
    }
    return place(toWorld, out) ? std::optional(out) : std::nullopt;
}

/// A light, if it is one, and what its node is called.
using NamedLight = std::pair<std::optional<Light>, std::string>;

std::vector<NamedLight> luminairesOf(const Json& root, const NodeWalk& walk, Luminaires& luminaires) {
    std::vector<NamedLight> lights;
    for (const PlacedNode* const at : nodesWith(root, walk, luminaireOf))
        lights.emplace_back(luminaireAt(member(root, "nodes")[at->node], at->toWorld, luminaires),
                            nodeName(root, at->node));
    return lights;
}

} // namespace

void addLights(const Json& root, const NodeWalk& walk, Luminaires& luminaires, ModelBuffers& model,
               ImportReport& report) {
    const std::vector<NamedLight> measured = luminairesOf(root, walk, luminaires);
    const bool inLumens = std::ranges::any_of(
        measured, [](const NamedLight& each) { return each.first && each.first->photometry != 0; });
    const float perUnit = inLumens ? static_cast<float>(1 / kLumensPerWatt) : 1;
    const Json& stated = member(extension(root, kPunctual), "lights");
    std::vector<NamedLight> all;
    for (const PlacedNode* const at : nodesWith(root, walk, punctualOf))
        all.emplace_back(
            punctualLight(element(stated, punctualOf(member(root, "nodes")[at->node])), at->toWorld, perUnit),
            nodeName(root, at->node));
    all.insert(all.end(), measured.begin(), measured.end());
    for (const auto& [light, name] : all) {
        if (light) {
            model.lights.push_back(*light);
            model.lights.back().nameOffset = model.addName(name);
        } else {
            addWarning(report, say(import_forms::kLightLeftOut, "'" + name + "'"));
        }
    }
}

} // namespace rtcore::gltf

#include "rtcore/io/import/gltf/lights.h"

#include "rtcore/io/import/gltf/node_order.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

/// False where it gives no light, or stands nowhere.
bool place(const Affine& toWorld, Light& out) {
    out.position = toWorld.point({});
    if (out.kind != LightKind::Point) {
        out.direction = normalize(toWorld.vector({0, 0, -1}));
        if (out.direction == Vec3{}) return false;
    }
    const Colour i = out.intensity;
    return isPlace(out.position) && i.r >= 0 && i.g >= 0 && i.b >= 0 && maxComponent(i) <= kBrightest &&
           !isBlack(i);
}

std::optional<Light> punctualLight(const Json& stated, const Affine& toWorld) {
    const auto kind = kindOf(stated);
    if (!kind) return std::nullopt;
    Light out;
    out.kind = *kind;
    out.intensity = colourOf(stated) * number(stated, "intensity", 1);
    if (out.kind == LightKind::Spot) setCone(member(stated, "spot"), out);
    return place(toWorld, out) ? std::optional(out) : std::nullopt;
}

/// As bright as its multiplier says: what its profile says is lost.
std::optional<Light> luminaire(const Json& node, const Affine& toWorld) {
    const Json& stated = extension(node, kIes);
    Light out;
    out.intensity = colourOf(stated) * number(stated, "multiplier", 1);
    return place(toWorld, out) ? std::optional(out) : std::nullopt;
}

} // namespace

void addLights(const Json& root, const NodeWalk& walk, ModelBuffers& model, ImportReport& report) {
    const auto add = [&](const std::optional<Light>& light, const std::string& name) {
        if (light) {
            model.lights.push_back(*light);
            model.lights.back().nameOffset = model.addName(name);
        } else {
            addWarning(report, say(import_forms::kLightLeftOut, "'" + name + "'"));
        }
    };
    const Json &lights = member(extension(root, kPunctual), "lights"), &nodes = member(root, "nodes");
    for (const PlacedNode* const at : nodesWith(root, walk, punctualOf))
        add(punctualLight(element(lights, punctualOf(nodes[at->node])), at->toWorld),
            nodeName(root, at->node));
    for (const PlacedNode* const at : nodesWith(root, walk, luminaireOf)) {
        const std::string name = nodeName(root, at->node);
        add(luminaire(nodes[at->node], at->toWorld), name);
        addWarning(report, say(import_forms::kPlainLuminaire, "'" + name + "'"));
    }
}

} // namespace rtcore::gltf

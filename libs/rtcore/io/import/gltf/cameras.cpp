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

constexpr float kWidestView = 5e15F;
constexpr float kUsualAspect = 4.0F / 3; ///< of cameras that state none, nor an angle
/// Of cameras that state none: images that are wider, as all are, have the stated vertical angle.
constexpr float kNarrowestImage = 0.1F;

std::optional<std::size_t> cameraOf(const Json& node) { return index(node, "camera"); }

float aspectWithin(float aspect) {
    constexpr float kMax = 1000;
    if (!(aspect > 0)) return kUsualAspect;
    return std::clamp(aspect, 1 / kMax, kMax);
}

/// Degrees, of an image of that aspect.
float horizontalAngle(float vertical, float aspect) {
    const float half = std::clamp(vertical / 2, 1e-3F, kPi / 2 - 1e-3F);
    return 2 * portableAtan2(portableSin(half) * aspect, portableCos(half)) * (180 / kPi);
}

/// Of a camera that states its aspect, the angle is rounded as the one that Assimp multiplies by it was.
void setLens(const Json& stated, Camera& out) {
    const Json& lens = member(stated, "perspective");
    const float aspect = number(lens, "aspectRatio", 0);
    const float angle = number(lens, "yfov", 0) * (aspect > 0 ? aspect : 1.0F);
    out.aspect = aspectWithin(aspect);
    out.horizontalFov = 60;
    if (!(angle > 0) || !(angle < kPi)) return;
    if (!(aspect > 0)) out.aspect = kNarrowestImage;
    const float vertical = aspect > 0 ? angle / out.aspect : angle;
    out.horizontalFov = std::clamp(horizontalAngle(vertical, out.aspect), 0.01F, 175.0F);
}

void setParallelView(const Json& stated, Camera& out) {
    const Json& view = member(stated, "orthographic");
    const float width = number(view, "xmag", 0), height = number(view, "ymag", 0);
    out.aspect = aspectWithin(height != 0 ? width / height : 1.0F);
    if (!(width > 0) || width > kWidestView) return;
    out.kind = CameraKind::Orthographic;
    out.orthographicWidth = 2 * width;
}

std::optional<Camera> camera(const Json& stated, const Affine& toWorld) {
    if (!stated.is_object()) return std::nullopt;
    Camera out;
    out.eye = toWorld.point({});
    out.forward = normalize(toWorld.vector({0, 0, -1}));
    out.up = normalize(toWorld.vector({0, 1, 0}));
    if (!isPlace(out.eye) || out.forward == Vec3{}) return std::nullopt;
    if (!(length(cross(out.forward, out.up)) > 1e-3F))
        out.up = std::fabs(out.forward.y) < 0.9F ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    if (text(stated, "type") == "orthographic") {
        setParallelView(stated, out);
    } else {
        setLens(stated, out);
    }
    return out;
}

} // namespace

void addCameras(const Json& root, const NodeWalk& walk, ModelBuffers& model, ImportReport& report) {
    const Json& nodes = member(root, "nodes");
    for (const PlacedNode* const at : nodesWith(root, walk, cameraOf)) {
        const Json& stated = element(member(root, "cameras"), cameraOf(nodes[at->node]));
        const std::string name = nodeName(root, at->node);
        if (auto out = camera(stated, at->toWorld)) {
            out->nameOffset = model.addName(name);
            model.cameras.push_back(*out);
        } else {
            addWarning(report, say(import_forms::kCameraLeftOut, "'" + name + "'"));
        }
    }
}

} // namespace rtcore::gltf

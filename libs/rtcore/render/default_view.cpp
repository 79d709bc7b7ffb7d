#include "rtcore/render/default_view.h"

#include "rtcore/math/constants.h"
#include "rtcore/render/survey.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr float kTwoPi = 6.28318530718F;
constexpr float kInteriorFov = 75;
constexpr float kExteriorFov = 45;

/// Looks along `forward` from so far that everything is in the image, also in one of 16:9.
Camera frameAll(const Mesh& mesh, const Box3& bounds, Vec3 forward, Vec3 upwards) {
    Camera camera;
    camera.horizontalFov = kExteriorFov;
    camera.up = upwards;
    camera.forward = forward;
    const Vec3 right = normalize(cross(forward, upwards));
    const Vec3 up = cross(right, forward);
    const float half = kExteriorFov * 0.5F * kTwoPi / 360;
    const float across = portableSin(half) / portableCos(half) * 0.95F;
    const float vertical = across * 9 / 16;

    // The middle of what is seen, then the distance at which its farthest corner still fits.
    Box3 seen;
    const auto project = [&](const Vertex& v) {
        const Vec3 p = v.position() - bounds.centre();
        return Vec3{dot(p, right), dot(p, up), dot(p, forward)};
    };
    constexpr std::size_t kSamples = 50'000;
    const std::size_t step = std::max<std::size_t>(1, mesh.vertices.size() / kSamples);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += step) seen.extend(project(mesh.vertices[i]));
    const Vec3 middle = seen.centre();
    float distance = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); i += step) {
        const Vec3 p = project(mesh.vertices[i]) - middle;
        distance = std::max({distance, std::fabs(p.x) / across - p.z, std::fabs(p.y) / vertical - p.z});
    }
    const Vec3 target = bounds.centre() + right * middle.x + up * middle.y + forward * middle.z;
    camera.eye = target - forward * (distance > 0 ? distance : 1.0F);
    return camera;
}

} // namespace

Camera defaultCamera(const KdTree& tree, const Mesh& mesh, Vec3 up) {
    const Axes axes(up);
    if (tree.bounds.empty()) return {};
    const Survey found = survey(tree, mesh, axes);
    if (found.indoors) {
        Camera camera;
        camera.eye = found.indoors->eye;
        camera.forward = found.indoors->longestView;
        camera.up = up;
        camera.horizontalFov = kInteriorFov;
        return camera;
    }
    const Vec3 from =
        found.openSide == Vec3{} ? axes.front + axes.right * 0.45F + axes.up * 0.35F : found.openSide;
    return frameAll(mesh, tree.bounds, -normalize(from), up);
}

bool isInterior(const KdTree& tree, const Mesh& mesh, Vec3 up) {
    return !tree.bounds.empty() && survey(tree, mesh, Axes(up)).indoors.has_value();
}

Light defaultLight(const Camera& camera, const Box3& bounds) {
    const Vec3 forward = normalize(camera.forward);
    const Vec3 right = normalize(cross(forward, camera.up));
    const Vec3 up = cross(right, forward);
    const float diagonal = bounds.diagonal();
    const float away = length(bounds.centre() - camera.eye);
    const bool inside = away < 0.5F * diagonal;
    const float side = inside ? 0.03F * diagonal : 0.35F * away;
    Light light;
    light.position = camera.eye + right * side + up * (inside ? side : 1.4F * side);
    // Indoors the light is as far from most walls as the room is wide.
    const float distance = inside ? 0.2F * diagonal : length(bounds.centre() - light.position);
    const float strength = kPi * std::max(distance * distance, 1e-30F);
    light.intensity = kWhite * strength;
    light.radius = 0.01F * diagonal;
    return light;
}

} // namespace rtcore

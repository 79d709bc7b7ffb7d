#include "rtcore/look/sun_of_view.h"

#include "rtcore/kernels/single_ray.h"
#include "rtcore/math/constants.h"
#include "rtcore/render/default_view.h"
#include "rtcore/render/survey.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace rtcore {

namespace {

constexpr float kDegree = kPi / 180;
constexpr int kAcross = 32, kDown = 18; ///< rays that look for what is seen
constexpr int kSides = 16;

/// A point of a surface, a little before it, and the surface's normal there to the viewer's side.
struct SeenPlace {
    Vec3 position, normal;
};

std::vector<SeenPlace> seenPlaces(const KdTree& tree, const Mesh& mesh, const Camera& camera) {
    const Vec3 forward = normalize(camera.forward);
    const Vec3 right = normalize(cross(forward, camera.up));
    const Vec3 up = cross(right, forward);
    const float half = 0.5F * camera.horizontalFov * kDegree;
    const float across = portableSin(half) / portableCos(half);
    std::vector<SeenPlace> places;
    for (int y = 0; y < kDown; ++y) {
        for (int x = 0; x < kAcross; ++x) {
            const float u = across * (2 * (static_cast<float>(x) + 0.5F) / kAcross - 1);
            const float v = across * (1 - 2 * (static_cast<float>(y) + 0.5F) / kDown) * kDown / kAcross;
            const Vec3 direction = normalize(forward + right * u + up * v);
            Hit hit;
            if (!intersect(tree, mesh, {camera.eye, 0, direction, std::numeric_limits<float>::max()}, hit))
                continue;
            constexpr float kBefore = 0.999F;
            const Vec3 normal = normalize(mesh.geometricNormal(hit.triangle));
            places.push_back(
                {camera.eye + direction * (kBefore * hit.t), dot(normal, direction) > 0 ? -normal : normal});
        }
    }
    return places;
}

Vec3 behindTheViewer(const Axes& axes, Vec3 forward) {
    constexpr float kHigh = 40 * kDegree, kLeft = 50 * kDegree;
    const Vec3 level = forward - axes.up * dot(forward, axes.up);
    const Vec3 back = length(level) > 1e-3F * length(forward) ? -normalize(level) : axes.front;
    const Vec3 left = cross(back, axes.up);
    return normalize((back * portableCos(kLeft) + left * portableSin(kLeft)) * portableCos(kHigh) +
                     axes.up * portableSin(kHigh));
}

} // namespace

Vec3 sunOfView(const KdTree& tree, const Mesh& mesh, Vec3 up, const Camera& camera) {
    const Axes axes(up);
    Vec3 best = behindTheViewer(axes, camera.forward);
    if (!isInterior(tree, mesh, up)) return best;
    const std::vector<SeenPlace> places = seenPlaces(tree, mesh, camera);
    float most = 0;
    for (const float height : {40 * kDegree, 25 * kDegree, 60 * kDegree}) {
        for (int i = 0; i < kSides; ++i) {
            const Vec3 sun = axes.horizontal(2 * kPi * static_cast<float>(i) / kSides) * portableCos(height) +
                             up * portableSin(height);
            float light = 0;
            for (const SeenPlace& place : places) {
                const float facing = dot(place.normal, sun);
                if (facing <= 0) continue;
                if (!occluded(tree, mesh, {place.position, 0, sun, std::numeric_limits<float>::max()}))
                    light += facing;
            }
            if (light <= most) continue;
            most = light;
            best = sun;
        }
    }
    return best;
}

} // namespace rtcore

#include "rtcore/look/sun_of_view.h"

#include "rtcore/kernels/single_ray.h"
#include "rtcore/look/visible_points.h"
#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace rtcore {

namespace {

constexpr float kDegree = kPi / 180;
constexpr int kSides = 16;

Vec3 behindTheViewer(const Axes& axes, Vec3 forward) {
    constexpr float kHigh = 40 * kDegree, kLeft = 50 * kDegree;
    const Vec3 level = forward - axes.up * dot(forward, axes.up);
    const Vec3 back = length(level) > 1e-3F * length(forward) ? -normalize(level) : axes.front;
    const Vec3 left = cross(back, axes.up);
    return normalize((back * portableCos(kLeft) + left * portableSin(kLeft)) * portableCos(kHigh) +
                     axes.up * portableSin(kHigh));
}

} // namespace

Vec3 sunOfView(const KdTree& tree, const Mesh& mesh, const Survey& survey, const Camera& camera) {
    const Axes& axes = survey.axes;
    Vec3 best = behindTheViewer(axes, camera.forward);
    if (!survey.inside()) return best;
    const std::vector<VisiblePoint> points = visiblePoints(tree, mesh, camera);
    float max = 0;
    for (const float height : {40 * kDegree, 25 * kDegree, 60 * kDegree}) {
        for (int i = 0; i < kSides; ++i) {
            const Vec3 sun = axes.horizontal(2 * kPi * static_cast<float>(i) / kSides) * portableCos(height) +
                             axes.up * portableSin(height);
            float light = 0;
            for (const VisiblePoint& point : points) {
                const float facing = dot(point.normal, sun);
                if (facing <= 0) continue;
                if (!occluded(tree, mesh, {point.position, 0, sun, std::numeric_limits<float>::max()}))
                    light += facing;
            }
            if (light <= max) continue;
            max = light;
            best = sun;
        }
    }
    return best;
}

} // namespace rtcore

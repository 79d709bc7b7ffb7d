#include "rtcore/render/lens.h"

#include "rtcore/simd/portable_math.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr float kHalfFilm = 0.018F; // metres
constexpr float kRadiansPerDegree = 0.01745329252F;
// Beyond, products leave the range of single precision.
constexpr float kNearest = 1e-15F, kWidest = 1e15F;

} // namespace

Lens makeLens(const CameraRays& view, float horizontalFov, float fNumber, float focus, float metresPerUnit) {
    const float half = horizontalFov * 0.5F * kRadiansPerDegree;
    const float film = kHalfFilm * portableCos(half) / portableSin(half) / view.widened();
    const float sharp = std::max(focus, kNearest);
    const bool infinite = !(sharp < kInfiniteFocus);
    const float focal = infinite ? film : film / (1 + film / (sharp * metresPerUnit));
    const float radius = std::min(focal / (2 * fNumber) / metresPerUnit, kWidest);
    return {normalize(view.plane().right) * radius, normalize(view.plane().down) * radius,
            infinite ? 0 : 1 / sharp};
}

float FocusFinder::distance(const RayTracer& tracer, const CameraRays& view, float x, float y) {
    ray_.clear();
    ray_.push(view.at(x, y));
    tracer.intersect(RayKind::Primary, ray_, hit_);
    if (!hit_.isHit(0)) return kInfiniteFocus;
    const Vec3 forward = cross(normalize(view.plane().right), normalize(view.plane().down));
    return hit_.t[0] * dot(ray_.ray(0).direction, forward);
}

} // namespace rtcore

#include "rtcore/render/camera_rays.h"

#include "rtcore/math/portable_math.h"

#include <limits>

namespace rtcore {

namespace {

constexpr float kRadiansPerDegree = 0.01745329252F;

Vec3 rightOf(Vec3 forward, Vec3 up) {
    constexpr float kParallel = 1e-6F; // below it, the cross product is nothing but rounding
    const Vec3 right = cross(forward, up);
    if (!(length(right) > kParallel)) return basisAround(forward).tangent;
    // A short product has a rounded direction: made perpendicular again, or pixels would be skewed.
    const Vec3 unit = normalize(right);
    return normalize(unit - forward * dot(unit, forward));
}

} // namespace

CameraRays::CameraRays(const Camera& camera, int width, int height) : eye_(camera.eye) {
    const Vec3 forward = normalize(camera.forward);
    const Vec3 right = rightOf(forward, normalize(camera.up));
    const Vec3 down = cross(forward, right);

    const float half = camera.horizontalFov * 0.5F * kRadiansPerDegree;
    const float pixel = 2 * portableSin(half) / portableCos(half) / static_cast<float>(width);
    right_ = right * pixel;
    down_ = down * pixel;
    corner_ =
        forward - right_ * (static_cast<float>(width) * 0.5F) - down_ * (static_cast<float>(height) * 0.5F);
}

Ray CameraRays::at(float x, float y) const {
    return {eye_, 0, normalize(corner_ + right_ * x + down_ * y), std::numeric_limits<float>::max()};
}

} // namespace rtcore

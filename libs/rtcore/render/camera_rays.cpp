#include "rtcore/render/camera_rays.h"

#include "rtcore/simd/portable_math.h"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/render/camera_rays.cpp"
#include "rtcore/simd/foreach_target.h"

#include "rtcore/math/float3-inl.h"
#include "rtcore/render/panorama-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

/// `at`: the direction of a point of the image.
template <typename At>
HWY_INLINE void fillBlock(const CameraRays::Block& block, float* dx, float* dy, float* dz, At at) {
    const auto position = [&](int first, Uint offset, float from) {
        return from + (toFloat(first + toInt(offset)) + 0.5F) * block.step;
    };
    for (std::uint32_t i = 0; i < kCameraBlock * kCameraBlock; i += static_cast<std::uint32_t>(lanes())) {
        const Uint index = iota(i);
        const Uint column = (index & 3U) | (shiftRight<2>(index) & 4U);
        const Uint row = (shiftRight<2>(index) & 3U) | (shiftRight<3>(index) & 4U);
        const Float x = position(block.column, column, block.left);
        const Float y = position(block.row, row, block.top);
        store(at(x, y), dx + i, dy + i, dz + i);
    }
}

void blockDirections(const CameraRays::Plane& plane, const CameraRays::Block& block, float* dx, float* dy,
                     float* dz) {
    const Float3 corner = broadcast(plane.corner), right = broadcast(plane.right),
                 down = broadcast(plane.down);
    fillBlock(block, dx, dy, dz, [&](Float x, Float y) { return normalize(corner + right * x + down * y); });
}

void blockAround(const CameraRays::Around& around, const CameraRays::Block& block, float* dx, float* dy,
                 float* dz) {
    fillBlock(block, dx, dy, dz, [&](Float x, Float y) { return directionAround(around, x, y); });
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(blockAround);
HWY_EXPORT(blockDirections);

namespace {

constexpr float kRadiansPerDegree = 0.01745329252F, kHalfTurn = 3.14159265359F;

Vec3 rightOf(Vec3 forward, Vec3 up) {
    constexpr float kParallel = 1e-6F; // below it, the cross product is nothing but rounding
    const Vec3 right = cross(forward, up);
    if (!(length(right) > kParallel)) return basisAround(forward).tangent;
    // A short product has a rounded direction: made perpendicular again, or pixels would be skewed.
    const Vec3 unit = normalize(right);
    return normalize(unit - forward * dot(unit, forward));
}

} // namespace

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : eye_(camera.eye), forward_(normalize(camera.forward)),
      parallel_(camera.kind == CameraKind::Orthographic), panorama_(camera.kind == CameraKind::Panorama),
      widened_(widening(camera, width, height)) {
    const Vec3 right = rightOf(forward_, normalize(camera.up));
    const Vec3 down = cross(forward_, right);
    if (panorama_) {
        widened_ = 1;
        around_ = {forward_, right, down, 2 * kHalfTurn / static_cast<float>(width),
                   kHalfTurn / static_cast<float>(height)};
        plane_ = {forward_, right * around_.column, down * around_.row};
        return;
    }

    const float half = camera.horizontalFov * 0.5F * kRadiansPerDegree;
    const float across = parallel_ ? camera.orthographicWidth : 2 * portableSin(half) / portableCos(half);
    const float pixel = across / static_cast<float>(width) * widened_;
    plane_.right = right * pixel;
    plane_.down = down * pixel;
    plane_.corner = (parallel_ ? Vec3{} : forward_) - plane_.right * (static_cast<float>(width) * 0.5F) -
                    plane_.down * (static_cast<float>(height) * 0.5F);
}

CameraRays CameraRays::coarser(int factor) const {
    CameraRays rays = *this;
    rays.plane_.right *= static_cast<float>(factor);
    rays.plane_.down *= static_cast<float>(factor);
    rays.around_.column *= static_cast<float>(factor);
    rays.around_.row *= static_cast<float>(factor);
    return rays;
}

Ray CameraRays::at(float x, float y) const {
    constexpr float kFar = std::numeric_limits<float>::max();
    if (panorama_) {
        float dx[kCameraBlockRays], dy[kCameraBlockRays], dz[kCameraBlockRays];
        directions({x - 0.5F, y - 0.5F, 0, 0, 1}, dx, dy, dz);
        return {eye_, 0, {dx[0], dy[0], dz[0]}, kFar};
    }
    const Vec3 seen = plane_.corner + plane_.right * x + plane_.down * y;
    if (parallel_) return {eye_ + seen, 0, forward_, kFar};
    return {eye_, 0, normalize(seen), kFar};
}

void CameraRays::directions(const Block& block, float* dx, float* dy, float* dz) const {
    if (panorama_) {
        HWY_DYNAMIC_DISPATCH(blockAround)(around_, block, dx, dy, dz);
    } else {
        HWY_DYNAMIC_DISPATCH(blockDirections)(plane_, block, dx, dy, dz);
    }
}

float fieldOfView(const Camera& camera, int width, int height) {
    if (camera.kind == CameraKind::Orthographic) return 0;
    if (camera.kind == CameraKind::Panorama) return 360;
    const float widened = widening(camera, width, height);
    if (widened == 1) return camera.horizontalFov;
    const float half = camera.horizontalFov * 0.5F * kRadiansPerDegree;
    return 2 / kRadiansPerDegree * portableAtan2(portableSin(half) * widened, portableCos(half));
}

} // namespace rtcore
#endif

#include "rtcore/render/camera_rays.h"

#include "rtcore/math/portable_math.h"

#include <limits>

#include "rtcore/platform/vector_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtcore/render/camera_rays.cpp"
#include <hwy/foreach_target.h>
// The loop over targets comes before the code that is compiled for each of them.
#include "rtcore/shading/vector_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtcore {
namespace HWY_NAMESPACE {

HWY_INLINE Vectors everywhere(Vec3 v) { return constant(v.x, v.y, v.z); }

void blockDirections(const CameraRays::Plane& plane, const CameraRays::Block& block, float* HWY_RESTRICT dx,
                     float* HWY_RESTRICT dy, float* HWY_RESTRICT dz) {
    const FloatTag d;
    const BitsTag du;
    const hn::RebindToSigned<FloatTag> di;
    const Floats half = constant(0.5F);
    const Floats step = constant(block.step);
    const Vectors corner = everywhere(plane.corner), right = everywhere(plane.right),
                  down = everywhere(plane.down);
    const auto place = [&](int first, Bits offset, float from) {
        const Floats whole = hn::ConvertTo(d, hn::Add(hn::Set(di, first), hn::BitCast(di, offset)));
        return hn::Add(constant(from), hn::Mul(hn::Add(whole, half), step));
    };
    const Bits lane = hn::Iota(du, 0);
    for (std::uint32_t i = 0; i < kCameraBlock * kCameraBlock;
         i += static_cast<std::uint32_t>(hn::Lanes(d))) {
        const Bits index = hn::Add(lane, hn::Set(du, i));
        const Bits column =
            hn::Or(hn::And(index, hn::Set(du, 3U)), hn::And(hn::ShiftRight<2>(index), hn::Set(du, 4U)));
        const Bits row = hn::Or(hn::And(hn::ShiftRight<2>(index), hn::Set(du, 3U)),
                                hn::And(hn::ShiftRight<3>(index), hn::Set(du, 4U)));
        const Floats x = place(block.column, column, block.left);
        const Floats y = place(block.row, row, block.top);
        const Vectors direction = normalize(corner + right * x + down * y, hn::Eq(half, half));
        storeVectors(direction, dx + i, dy + i, dz + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace rtcore
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtcore {

HWY_EXPORT(blockDirections);

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

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : eye_(camera.eye), forward_(normalize(camera.forward)),
      parallel_(camera.kind == CameraKind::Orthographic), widened_(widening(camera, width, height)) {
    const Vec3 right = rightOf(forward_, normalize(camera.up));
    const Vec3 down = cross(forward_, right);

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
    return rays;
}

Ray CameraRays::at(float x, float y) const {
    constexpr float kFar = std::numeric_limits<float>::max();
    const Vec3 seen = plane_.corner + plane_.right * x + plane_.down * y;
    if (parallel_) return {eye_ + seen, 0, forward_, kFar};
    return {eye_, 0, normalize(seen), kFar};
}

void CameraRays::directions(const Block& block, float* dx, float* dy, float* dz) const {
    HWY_DYNAMIC_DISPATCH(blockDirections)(plane_, block, dx, dy, dz);
}

float fieldOfView(const Camera& camera, int width, int height) {
    if (camera.kind == CameraKind::Orthographic) return 0;
    const float widened = widening(camera, width, height);
    if (widened == 1) return camera.horizontalFov;
    const float half = camera.horizontalFov * 0.5F * kRadiansPerDegree;
    return 2 / kRadiansPerDegree * portableAtan2(portableSin(half) * widened, portableCos(half));
}

} // namespace rtcore
#endif

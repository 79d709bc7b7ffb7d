/// A camera: with a flat (rectilinear) image, or all around. The record is written to .bsp files as it stands
/// here.
#pragma once

#include "rtcore/math/vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace rtcore {

/// Perspective: all rays start at the eye. Orthographic: all are parallel to `forward`. Panorama: all around
/// the eye, equirectangular, with `forward` in the middle and `up` upright; no file holds it.
enum class CameraKind : std::uint32_t { Perspective = 0, Orthographic = 1, Panorama = 2 };

struct Camera {
    Vec3 eye;                 ///< scene units
    Vec3 forward{0, 0, -1};   ///< need not be of unit length; not zero
    Vec3 up{0, 1, 0};         ///< need not be perpendicular to `forward`, only not parallel
    float horizontalFov = 60; ///< degrees between the left and right edge of the image, 0 < fov < 180; with
                              ///< an `aspect`, of an image of that aspect
    std::uint32_t nameOffset = 0;
    CameraKind kind = CameraKind::Perspective;
    float orthographicWidth = 0; ///< orthographic: scene units between the left and right edge, above 0
    float aspect = 0;            ///< width over height that its author framed; 0: unknown

    friend bool operator==(const Camera&, const Camera&) = default;
};
static_assert(std::is_trivially_copyable_v<Camera> && sizeof(Camera) == 56);

/// How many times as wide as the scene's author framed it an image of this size shows the scene: an image
/// wider than the author's shows more at the sides, a narrower one more above and below. 1 where the camera
/// has no aspect.
inline float widening(const Camera& camera, int width, int height) {
    if (!(camera.aspect > 0)) return 1;
    return std::max(1.0F, static_cast<float>(width) / static_cast<float>(height) / camera.aspect);
}

/// As good as parallel, to either side: no image can be set upright by `b`.
inline bool areParallel(Vec3 a, Vec3 b) {
    constexpr float kSine = 1e-5F;
    return length(cross(normalize(a), normalize(b))) < kSine;
}

/// The up direction of an image that looks along `forward`: `up`, or, where it looks straight up or down, the
/// direction that would be at the top if it had turned there from looking along -z (+y where `up` is z).
inline Vec3 upwardsOf(Vec3 forward, Vec3 up) {
    if (!areParallel(forward, up)) return up;
    const Vec3 ahead = std::fabs(up.z) > std::fabs(up.y) ? Vec3{0, 1, 0} : Vec3{0, 0, -1};
    return dot(forward, up) < 0 ? ahead : -ahead;
}

} // namespace rtcore

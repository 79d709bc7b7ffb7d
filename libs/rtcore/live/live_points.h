/// What the pixels of a moving picture see, and the light that is known of it.
#pragma once

#include "rtcore/live/image_plane.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/shading/light/light_visibility.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace rtcore {

/// 20 bytes, together, so that all that is asked of a neighbour comes with one line of the cache.
struct LivePoint {
    /// The depth of pixels that see nothing: the background is infinitely far.
    static constexpr float kFar = std::numeric_limits<float>::max();
    /// Of `flags`.
    static constexpr std::uint8_t kLit = 1;           ///< `light` is known
    static constexpr std::uint8_t kViewDependent = 2; ///< the surface mirrors, shines or is transparent

    float depth = 0;          ///< along the axis of view, scene units; 0: nothing is known of the pixel
    LightVisibility lights;   ///< what is known of them at the point
    std::uint32_t light = 0;  ///< radiance towards the eye, packLight()
    std::uint16_t normal = 0; ///< geometric, on the side of the viewer, packNormal()
    std::int8_t across = 0,
                down = 0; ///< from the middle of the pixel to where the light is from, in 1/64 pixel
    std::uint8_t age = 0; ///< frames since the light was traced, at most 255
    std::uint8_t flags = 0;

    bool known() const { return depth > 0; }
    bool far() const { return depth == kFar; }
    bool lit() const { return (flags & kLit) != 0; }
    bool viewDependent() const { return (flags & kViewDependent) != 0; }
};
static_assert(sizeof(LivePoint) == 20 && std::is_trivially_copyable_v<LivePoint>);

/// Of LivePoint::across and down, for a pixel.
inline constexpr float kOffsetSteps = 64;

/// A unit vector within a degree: octahedral, 8 bits for each coordinate. (Meyer et al. 2010, "On
/// Floating-Point Normal Vectors")
std::uint16_t packNormal(Vec3 normal);
Vec3 unpackNormal(std::uint16_t packed);

/// Three mantissas of 9 bits with one exponent of 5: within 1/512 of the largest channel, from 2^-15 to
/// 65408. (OpenGL's RGB9_E5)
std::uint32_t packLight(Colour light);
Colour unpackLight(std::uint32_t packed);

/// The pixels of a frame, row by row.
struct LiveImage {
    ImagePlane plane;
    std::vector<LivePoint> points;

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(plane.width) +
               static_cast<std::size_t>(x);
    }
    LivePoint& at(int x, int y) { return points[index(x, y)]; }
    const LivePoint& at(int x, int y) const { return points[index(x, y)]; }
    /// Where the pixel's point is; of a far one its direction.
    Vec3 offsetFromEye(int x, int y) const {
        const Vec3 towards = plane.towards(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
        const float depth = at(x, y).depth;
        return depth == LivePoint::kFar ? towards : towards * depth;
    }
};

/// 0..63: the turn of a pixel among its neighbours, which are far apart in time. (Bayer 1973)
constexpr std::uint32_t turnOf(int x, int y) {
    std::uint32_t turn = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const std::uint32_t a = static_cast<std::uint32_t>(x) >> bit & 1U;
        const std::uint32_t b = static_cast<std::uint32_t>(y) >> bit & 1U;
        turn = turn << 2 | (a ^ b) << 1 | b;
    }
    return turn;
}
inline constexpr std::uint32_t kTurns = 64;

} // namespace rtcore

/// Irradiance that is known at points of surfaces, to be interpolated between them. (Ward, Rubinstein and
/// Clear 1988, "A Ray Tracing Solution for Diffuse Interreflection")
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace rtcore {

/// Records are made in three densities, so that few of them soon cover what is seen, and many later.
inline constexpr int kDensities = 3; ///< 0: the finest

/// Radii of records: a fraction of the harmonic mean of how far their rays go, within bounds that count in
/// pixels, since more cannot be seen and less is noise.
struct RecordRadii {
    static constexpr float kOfDistance = 0.4F;
    static constexpr float kMinPixels = 8, kMaxPixels = 48;
    /// Of those of the finest density; and their bounds in pixels.
    static constexpr float kScale[kDensities] = {1, 3, 9};
    static constexpr float kMaxPixelsOf[kDensities] = {48, 144, 240};

    /// That of a record of this density where rays go so far and pixels are so large.
    static float of(int density, float distance, float pixel) {
        const float fine = std::clamp(kOfDistance * distance, kMinPixels * pixel, kMaxPixels * pixel);
        return std::min(kScale[density] * fine, kMaxPixelsOf[density] * pixel);
    }
};

/// A surface that the rays of a record met, as a plane: the record tells nothing of points behind it.
struct RecordWall {
    Vec3 normal; ///< unit, towards the record
    float offset = -std::numeric_limits<float>::max();

    bool isBefore(Vec3 point) const { return dot(normal, point) >= offset; }
    friend bool operator==(const RecordWall&, const RecordWall&) = default;
};

/// All lengths are in scene units.
struct IrradianceRecord {
    Vec3 position;
    float radius = 0;     ///< it tells of points that are nearer
    Vec3 normal;          ///< of the face, unit, on the side that light arrives at
    float confidence = 0; ///< 0: it knows nothing yet; to 1
    Colour irradiance;
    /// The part along the surface of the mean direction that light arrives from, times the ratio of scalar
    /// and plane irradiance; at most of length 1. Shading normals that lean there get more.
    Vec3 slant;
    float distance = 0; ///< the harmonic mean of how far rays go from here, as far as its neighbours allow
    /// The nearest one, and the nearest of those that face elsewhere: a corner has two.
    std::array<RecordWall, 2> walls;

    friend bool operator==(const IrradianceRecord&, const IrradianceRecord&) = default;
};

/// A point of a surface that asks for its irradiance.
struct Receiver {
    Vec3 position;
    Vec3 face;       ///< the face's normal, unit, on the side of the viewer
    Vec3 normal;     ///< the shading normal, unit
    float pixel = 0; ///< size of a pixel there; not above 0: nothing is asked
};

struct ArrivingLight {
    Colour irradiance;
    /// The coarsest density of which there are too few records here; -1: there are enough of each.
    std::int8_t lacking = -1;
    /// The mean of what the records around say of IrradianceRecord::distance; infinite where there are none.
    float distance = 0;
    /// The sum of the weights of records that know something; 0: the irradiance is a guess.
    float weight = 0;
};

} // namespace rtcore

/// Directions drawn in proportion to the light that comes from them: of an image, of the map of a sky, or of
/// an even background.
#pragma once

#include "rtcore/lights/background_light.h"
#include "rtcore/sampling/alias_table.h"
#include "rtcore/sampling/sample_id.h"

#include <cstdint>

namespace rtcore {

/// What vector code reads, see environment_draw-inl.h.
struct EnvironmentRows {
    AliasRows cells;  ///< of the unfolded octahedron (math/octahedron-inl.h), row by row
    int side = 0;     ///< cells each way, a power of two
    int sideBits = 0; ///< its logarithm
};

struct DrawnDirection {
    Vec3 direction;    ///< unit
    float density = 0; ///< by solid angle
};

/// A table of cells of the sphere, about as many as the image has texels. A cell's weight is its solid angle
/// times the *largest* luminance in it and its 8 neighbours: filtered lookups show a bright texel in cells
/// around it too, and with the cell's own light as weight these would be drawn far too rarely.
///
/// Immutable once prepared; safe from many threads. 12 bytes for each cell, of which there are at most 2^22.
class EnvironmentDraw {
  public:
    /// Takes some 10^-7 s for each cell, on one thread; the same on every machine. Black light makes it
    /// empty.
    void prepare(const BackgroundLight& light);

    /// Nothing shines.
    bool empty() const { return table_.empty(); }

    /// There is light. `bits`: 32 random ones. What shines from there is BackgroundLight::radiance() of it.
    DrawnDirection draw(SquarePoint point, std::uint32_t bits) const;
    /// The density by solid angle with which draw() finds a direction, above 0 for all of them: of one it
    /// gave the same number to the bit. `direction`: of unit length. 0 when empty.
    float density(Vec3 direction) const;

    /// Luminance of the light from all directions: the integral of the radiance over the sphere.
    double scalarIrradiance() const { return scalarIrradiance_; }
    EnvironmentRows rows() const { return {table_.rows(), side_, sideBits_}; }

  private:
    AliasTable table_;
    int side_ = 0, sideBits_ = 0;
    double scalarIrradiance_ = 0;
};

} // namespace rtcore

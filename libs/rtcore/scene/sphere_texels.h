/// Where the texels of an equirectangular image lie, as Environment::fromEquirectangular() takes it.
#pragma once

#include "rtcore/math/vec.h"

#include <cstddef>
#include <vector>

namespace rtcore {

/// The directions of the texels of an image twice as wide as it is high. The same bits on every processor.
class SphereTexels {
  public:
    explicit SphereTexels(int height);

    /// The sine and the cosine of the angle between a row's texels and the y axis.
    struct Row {
        float ring, height;
    };
    Row row(int y) const;
    /// The direction of the middle of a texel; of unit length, but for rounding.
    Vec3 direction(Row row, int x) const {
        const Vec2 across = across_[static_cast<std::size_t>(x)];
        return {row.ring * across.x, row.height, row.ring * across.y};
    }

  private:
    float texel_; ///< radians
    std::vector<Vec2> across_;
};

} // namespace rtcore

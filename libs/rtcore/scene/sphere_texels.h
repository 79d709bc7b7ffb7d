/// Where the texels of an equirectangular image lie, as Environment::fromEquirectangular() takes it.
#pragma once

#include "rtcore/math/vec.h"

#include <cstddef>
#include <vector>

namespace rtcore {

/// Of an image twice as wide as it is high. The same bits on every processor.
class SphereTexels {
  public:
    explicit SphereTexels(int height);

    /// Of the texels of a row: the sine and the cosine of their angle to the y axis.
    struct Row {
        float ring, height;
    };
    Row row(int y) const;
    /// Of the middle of a texel; of unit length, but for rounding.
    Vec3 direction(Row row, int x) const {
        const Vec2 across = across_[static_cast<std::size_t>(x)];
        return {row.ring * across.x, row.height, row.ring * across.y};
    }

  private:
    float texel_; ///< radians
    std::vector<Vec2> across_;
};

} // namespace rtcore

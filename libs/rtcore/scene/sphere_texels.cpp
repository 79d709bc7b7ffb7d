#include "rtcore/scene/sphere_texels.h"

#include "rtcore/math/constants.h"
#include "rtcore/simd/portable_math.h"

namespace rtcore {

SphereTexels::SphereTexels(int height) : texel_(kPi / static_cast<float>(height)) {
    for (int x = 0; x < 2 * height; ++x) {
        const float angle = (static_cast<float>(x) + 0.5F) * texel_ - kPi;
        across_.push_back({portableSin(angle), -portableCos(angle)});
    }
}

SphereTexels::Row SphereTexels::row(int y) const {
    const float polar = (static_cast<float>(y) + 0.5F) * texel_;
    return {portableSin(polar), portableCos(polar)};
}

} // namespace rtcore

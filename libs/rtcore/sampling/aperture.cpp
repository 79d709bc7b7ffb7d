#include "rtcore/sampling/aperture.h"

#include "rtcore/math/constants.h"
#include "rtcore/sampling/disc-inl.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

Vec2 onDisc(SquarePoint point) {
    const auto [x, y] = HWY_NAMESPACE::onDisc(point.u, point.v);
    return {x, y};
}

void Aperture::prepare(int corners) {
    const std::size_t wanted = corners < 3 ? 0 : static_cast<std::size_t>(corners) + 1;
    if (corners_.size() == wanted) return;
    corners_.clear();
    for (std::size_t i = 0; i < wanted; ++i) {
        const float angle = 2 * kPi * static_cast<float>(i % (wanted - 1)) / static_cast<float>(wanted - 1);
        corners_.push_back({portableSin(angle), portableCos(angle)});
    }
}

Vec2 Aperture::at(SquarePoint point) const {
    if (corners_.empty()) return onDisc(point);
    // A triangle from the middle to two corners, and a point in it.
    const std::size_t sides = corners_.size() - 1;
    const float scaled = point.u * static_cast<float>(sides);
    const std::size_t side = std::min(static_cast<std::size_t>(scaled), sides - 1);
    const float along = scaled - static_cast<float>(side);
    const float out = std::sqrt(point.v);
    const Vec2 a = corners_[side], b = corners_[side + 1];
    return {out * (a.x + along * (b.x - a.x)), out * (a.y + along * (b.y - a.y))};
}

} // namespace rtcore

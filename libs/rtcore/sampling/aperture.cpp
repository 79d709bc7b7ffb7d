#include "rtcore/sampling/aperture.h"

#include "rtcore/math/portable_math.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr float kPi = 3.14159265359F;

/// Of angles up to 45 degrees; absolute errors below 1e-7.
float shortSin(float x) {
    const float z = x * x;
    return x * (1 + z * (-1.0F / 6 + z * (1.0F / 120 + z * (-1.0F / 5040 + z * (1.0F / 362880)))));
}
float shortCos(float x) {
    const float z = x * x;
    return 1 + z * (-1.0F / 2 + z * (1.0F / 24 + z * (-1.0F / 720 + z * (1.0F / 40320 - z * (1.0F / 3628800)))));
}

} // namespace

Vec2 onDisc(SquarePoint point) {
    const float a = 2 * point.u - 1, b = 2 * point.v - 1;
    if (a == 0 && b == 0) return {};
    // The angle from the nearer axis, which the coordinate that is larger follows.
    const bool across = std::fabs(a) > std::fabs(b);
    const float r = across ? a : b;
    const float angle = kPi / 4 * ((across ? b : a) / r);
    const float along = r * shortCos(angle), aside = r * shortSin(angle);
    return across ? Vec2{along, aside} : Vec2{aside, along};
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

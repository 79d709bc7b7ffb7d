#include "rtcore/sampling/aperture.h"

#include "rtcore/math/portable_math.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr float kPi = 3.14159265359F;

template <std::size_t N>
float polynomial(const std::array<float, N>& factors, float z) {
    float sum = factors[0];
    for (std::size_t i = 1; i < N; ++i) sum = factors[i] + z * sum;
    return sum;
}

} // namespace

Vec2 onDisc(SquarePoint point) {
    const float a = 2 * point.u - 1, b = 2 * point.v - 1;
    // The angle from the nearer axis, which the coordinate that is larger follows.
    const bool across = std::fabs(a) > std::fabs(b);
    const float r = across ? a : b;
    if (r == 0) return {};
    const float angle = kDiscAngle * ((across ? b : a) / r);
    const float along = r * polynomial(kDiscCosine, angle * angle);
    const float aside = r * (angle * polynomial(kDiscSine, angle * angle));
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

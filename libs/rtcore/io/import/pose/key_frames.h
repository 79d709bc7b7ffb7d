/// Values between the keys of animations.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace rtcore {

/// A quaternion: x, y, z, w.
using Rotation = std::array<double, 4>;

/// Where a time lies among keys: `part` of the way from one to the next, or on one alone where both are
/// the same.
struct KeyInterval {
    std::size_t from = 0, to = 0;
    double part = 0;   ///< 0 to 1
    double length = 0; ///< from one to the other, in the unit of the times
};

/// Before the first key and behind the last these hold. `timeOf(i)` ascends; `count` is not 0. Where keys
/// have the same time, the last of them counts.
template <typename TimeOf>
KeyInterval keyInterval(std::size_t count, double time, TimeOf timeOf) {
    std::size_t begin = 0, end = count; // the first key behind `time` lies between them
    while (begin < end) {
        const std::size_t middle = begin + (end - begin) / 2;
        if (timeOf(middle) <= time)
            begin = middle + 1;
        else
            end = middle;
    }
    if (begin == 0) return {0, 0, 0, 0};
    if (begin == count) return {count - 1, count - 1, 0, 0};
    const double length = timeOf(begin) - timeOf(begin - 1);
    return {begin - 1, begin, (time - timeOf(begin - 1)) / length, length};
}

/// Along the shorter arc between two unit quaternions.
inline Rotation slerp(const Rotation& a, const Rotation& b, double part) {
    double cosine = 0;
    for (std::size_t i = 0; i < 4; ++i) cosine += a[i] * b[i];
    const double sign = cosine < 0 ? -1 : 1;
    cosine = std::fabs(cosine);
    constexpr double kNearlyOne = 1 - 1e-9; // where the sine below has no digits left
    const double angle = cosine < kNearlyOne ? std::acos(cosine) : 0;
    const double sine = std::sin(angle);
    const double wa = sine > 0 ? std::sin((1 - part) * angle) / sine : 1 - part;
    const double wb = sign * (sine > 0 ? std::sin(part * angle) / sine : part);
    Rotation r{};
    for (std::size_t i = 0; i < 4; ++i) r[i] = wa * a[i] + wb * b[i];
    return r;
}

/// The value of a cubic Hermite spline whose tangents are changes per unit of time (glTF 2.0, appendix C.5).
inline double hermite(double from, double outTangent, double inTangent, double to, double part,
                      double length) {
    const double t = part, t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * from + length * (t3 - 2 * t2 + t) * outTangent + (-2 * t3 + 3 * t2) * to +
           length * (t3 - t2) * inTangent;
}

} // namespace rtcore

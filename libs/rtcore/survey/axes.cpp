#include "rtcore/survey/axes.h"

#include "rtcore/scene/up_axis.h"
#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

Axes::Axes(Vec3 upwards, float metresPerUnit) : up(upwards), metre(1 / metresPerUnit) {
    right = rightOf(up);
    front = frontOf(up);
}

Vec3 Axes::horizontal(float angle) const { return right * portableCos(angle) + front * portableSin(angle); }

float extentAlong(const Box3& box, Vec3 axis) { return std::fabs(dot(box.size(), axis)); }

Range rangeAlong(const Box3& box, Vec3 axis) {
    const float a = dot(box.lo, axis), b = dot(box.hi, axis);
    return {std::min(a, b), std::max(a, b)};
}

} // namespace rtcore

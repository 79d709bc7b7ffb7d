#include "rtcore/render/axes.h"

#include "rtcore/simd/portable_math.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

Axes::Axes(Vec3 upwards, float metresPerUnit) : up(upwards), metre(1 / metresPerUnit) {
    // What a viewer of the usual +Y models calls front is +Z; other up axes follow by turning the model.
    right = std::fabs(up.x) < 0.5F ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    front = cross(right, up);
}

Vec3 Axes::horizontal(float angle) const { return right * portableCos(angle) + front * portableSin(angle); }

float extentAlong(const Box3& box, Vec3 axis) { return std::fabs(dot(box.size(), axis)); }

Range rangeAlong(const Box3& box, Vec3 axis) {
    const float a = dot(box.lo, axis), b = dot(box.hi, axis);
    return {std::min(a, b), std::max(a, b)};
}

} // namespace rtcore

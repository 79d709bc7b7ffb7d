#include "rtcore/math/triangle.h"

#include "rtcore/math/triangle-inl.h"

namespace rtcore {

float surfaceClearance(Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
    return HWY_NAMESPACE::surfaceClearance<float>({a, b, c}, normal);
}

} // namespace rtcore

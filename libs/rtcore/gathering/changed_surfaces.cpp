#include "rtcore/gathering/changed_surfaces.h"

#include "rtcore/gathering/curve_order.h"
#include "rtcore/math/constants.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

Box3 boxOf(const Mesh& mesh, std::uint32_t triangle) {
    Box3 box;
    for (int corner = 0; corner < 3; ++corner) box.extend(mesh.position(triangle, corner));
    return box;
}

float distanceTo(const Box3& box, Vec3 point) {
    Vec3 apart;
    for (int axis = 0; axis < 3; ++axis)
        apart[axis] = std::max({box.lo[axis] - point[axis], point[axis] - box.hi[axis], 0.0F});
    return length(apart);
}

/// Of the corner that is farthest in this direction.
float farthest(const Box3& box, Vec3 direction) {
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis)
        sum += direction[axis] * (direction[axis] > 0 ? box.hi[axis] : box.lo[axis]);
    return sum;
}

/// The area of its shadow along a direction of unit length.
float shadowOf(const Box3& box, Vec3 direction) {
    const Vec3 size = box.size();
    return std::fabs(direction.x) * size.y * size.z + std::fabs(direction.y) * size.z * size.x +
           std::fabs(direction.z) * size.x * size.y;
}

/// The part of what arrives at a record that a box takes, about; `height`: of its highest point above the
/// record's plane, `distance`: that of its nearest one.
float partTaken(const Box3& box, Vec3 point, float height, float distance) {
    const Vec3 apart = box.centre() - point;
    const float toCentre = length(apart), between = 0.5F * (toCentre + distance);
    const float solidAngle = shadowOf(box, toCentre > 0 ? apart / toCentre : apart) / (between * between);
    return std::min(solidAngle / kPi, 1.0F) * std::min(height / distance, 1.0F);
}

} // namespace

/// Those that lie together along a curve are in one box.
void ChangedSurfaces::find(const Mesh& mesh, std::span<const std::uint8_t> before,
                           std::span<const std::uint8_t> now) {
    constexpr std::size_t kMaxBoxes = 256;
    boxes_.clear();
    Box3 all;
    std::vector<std::uint64_t> changed;
    for (std::uint32_t triangle = 0; triangle < before.size(); ++triangle) {
        if ((before[triangle] != 0) == (now[triangle] != 0)) continue;
        all.extend(boxOf(mesh, triangle));
        changed.push_back(triangle);
    }
    for (std::uint64_t& each : changed)
        each |= std::uint64_t{alongCurve(boxOf(mesh, static_cast<std::uint32_t>(each)).centre(), all)} << 32;
    std::ranges::sort(changed);
    const std::size_t inOne = (changed.size() + kMaxBoxes - 1) / kMaxBoxes;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        if (i % inOne == 0) boxes_.emplace_back();
        boxes_.back().extend(boxOf(mesh, static_cast<std::uint32_t>(changed[i])));
    }
}

/// Not where they lie behind the surface, or behind walls behind which the record tells nothing.
bool ChangedSurfaces::areNear(const IrradianceRecord& record) const {
    constexpr float kSlack = 1e-3F;   // of the radius: what lies in the surface
    constexpr float kOfRadius = 0.1F; // so much of the harmonic mean distance may be another
    const float plane = dot(record.normal, record.position);
    float inverse = 0;
    for (const Box3& box : boxes_) {
        const float height = farthest(box, record.normal) - plane;
        const float distance = distanceTo(box, record.position);
        const bool inSurface = distance <= kSlack * record.radius;
        if (!inSurface && height <= kSlack * record.radius) continue;
        if (std::ranges::any_of(record.walls, [&](const RecordWall& wall) {
                return farthest(box, wall.normal) < wall.offset;
            }))
            continue;
        if (distance < record.radius) return true;
        inverse += partTaken(box, record.position, height, distance) / distance;
    }
    return inverse * record.distance > kOfRadius;
}

} // namespace rtcore

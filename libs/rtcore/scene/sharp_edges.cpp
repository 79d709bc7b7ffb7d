#include "rtcore/scene/sharp_edges.h"

#include <algorithm>

namespace rtcore {

Vec3d exactNormal(const Mesh& mesh, std::uint32_t triangle) {
    const auto position = [&](int corner) {
        const Vertex& v = mesh.vertices[mesh.triangles[triangle].v[corner]];
        return Vec3d{v.x, v.y, v.z};
    };
    const Vec3d n = cross(position(1) - position(0), position(2) - position(0));
    const double size = length(n);
    return size > 0 ? n * (1 / size) : n;
}

bool isSharp(const Mesh& mesh, std::span<const HalfEdge> sides, const Indices& triangles) {
    constexpr double kBend = 0.94; // the cosine of 20 degrees
    if (sides.size() == 1) return true;
    const Vec3d first = exactNormal(mesh, triangles[sides[0].triangle]);
    return std::ranges::any_of(sides.subspan(1), [&](const HalfEdge& side) {
        const Vec3d normal = exactNormal(mesh, triangles[side.triangle]);
        return dot(first, side.forward == sides[0].forward ? normal * -1.0 : normal) < kBend;
    });
}

} // namespace rtcore

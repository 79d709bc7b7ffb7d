/// Closed meshes, and rays from inside them, aimed where cells and triangles meet.
#pragma once

#include "rtcore/math/triangle.h"
#include "rtcore/math/vec.h"
#include "support/sample_meshes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace test {

enum class Solid { Box, Sphere, Torus };

/// A closed mesh, and a point inside it for each vertex such that all between the two is inside as well.
struct ClosedMesh {
    SampleMesh surface, inside;
};

inline ClosedMesh makeSolid(Solid solid, float offset) {
    ClosedMesh mesh;
    switch (solid) {
    case Solid::Box:
        mesh.surface = boxGrid(24);
        break;
    case Solid::Sphere:
        mesh.surface = icosphere(5);
        break;
    case Solid::Torus:
        mesh.surface = torus(125, 80);
        break;
    }
    mesh.inside.vertices = mesh.surface.vertices;
    mesh.inside.map([=](rtcore::Vec3 p) {
        return solid == Solid::Torus ? normalize(rtcore::Vec3{p.x, p.y, 0}) * 0.7F : rtcore::Vec3{};
    });
    for (SampleMesh* part : {&mesh.surface, &mesh.inside}) {
        if (solid != Solid::Box) part->rotate(2023);
        part->move({offset, -offset, offset});
    }
    return mesh;
}

/// Around where rays start: in the depth at some distance from a vertex, or just below a triangle.
struct StartPlace {
    bool onSurface;
    std::uint32_t index; ///< of the triangle or the vertex
    float depth;         ///< the fraction of the way from the vertex to the point inside
};

class LeakAim {
  public:
    explicit LeakAim(const ClosedMesh& mesh) : mesh_(mesh), view_(mesh.surface.view()) {
        for (int axis = 0; axis < 3; ++axis) {
            auto& sorted = coordinates_[static_cast<std::size_t>(axis)];
            for (const rtcore::Vertex& v : mesh.surface.vertices) sorted.push_back(v.position()[axis]);
            std::sort(sorted.begin(), sorted.end());
        }
    }

    const rtcore::Mesh& mesh() const { return view_; }

    StartPlace place(bool onSurface, Random& random) const {
        const std::size_t count = onSurface ? view_.triangles.size() : mesh_.surface.vertices.size();
        const std::uint32_t index = random.index(count);
        return {onSurface, index, random.number(0.1F, 1)};
    }
    /// One of many points close to each other.
    rtcore::Vec3 start(const StartPlace& place, Random& random) const {
        if (place.onSurface) return pointBelow(place.index, random);
        const float depth = place.depth * random.number(0.9F, 1);
        return mesh_.surface.vertices[place.index].position() * (1 - depth) +
               mesh_.inside.vertices[place.index].position() * depth;
    }
    /// On a triangle, one of four in turn: a corner (twice), a point of an edge, and one where a plane of the
    /// tree may cut the edge.
    rtcore::Vec3 target(std::uint64_t number, std::uint32_t triangle, Random& random) const {
        const int first = static_cast<int>(random.index(3));
        const rtcore::Vec3 a = view_.position(triangle, first);
        const rtcore::Vec3 b = view_.position(triangle, (first + 1) % 3);
        if (number % 4 < 2) return a;
        return number % 4 == 2 ? a + (b - a) * random.number(0, 1) : pointAtPlane(a, b, random);
    }
    std::uint32_t anyTriangle(Random& random) const { return random.index(view_.triangles.size()); }

  private:
    /// Where a ray goes on after a hit: moved inwards by the offset that secondary rays get.
    rtcore::Vec3 pointBelow(std::uint32_t triangle, Random& random) const {
        const float u = random.number(0.1F, 0.8F);
        const float v = random.number(0.1F, 0.9F - u);
        const rtcore::Vec3 a = view_.position(triangle, 0);
        const rtcore::Vec3 b = view_.position(triangle, 1);
        const rtcore::Vec3 c = view_.position(triangle, 2);
        const rtcore::Vec3 p = a * (1 - u - v) + b * u + c * v;
        const rtcore::Vec3 normal = normalize(view_.geometricNormal(triangle));
        const rtcore::Vec3 inwards = mesh_.inside.vertices[view_.triangles[triangle].v[0]].position() - p;
        const float step = rtcore::surfaceClearance(a, b, c, normal);
        return p + normal * (dot(normal, inwards) > 0 ? step : -step);
    }
    /// Splits are at coordinates of vertices: the point of an edge that has one of those.
    rtcore::Vec3 pointAtPlane(rtcore::Vec3 a, rtcore::Vec3 b, Random& random) const {
        const int axis = static_cast<int>(random.index(3));
        const auto& sorted = coordinates_[static_cast<std::size_t>(axis)];
        const auto from = std::lower_bound(sorted.begin(), sorted.end(), std::min(a[axis], b[axis]));
        const auto to = std::upper_bound(sorted.begin(), sorted.end(), std::max(a[axis], b[axis]));
        const float plane = from[random.index(static_cast<std::size_t>(to - from))];
        const float length = b[axis] - a[axis];
        rtcore::Vec3 p = length != 0 ? a + (b - a) * ((plane - a[axis]) / length) : a;
        p[axis] = plane;
        return p;
    }

    const ClosedMesh& mesh_;
    rtcore::Mesh view_;
    std::array<std::vector<float>, 3> coordinates_;
};

} // namespace test

/// Meshes for tests of the kd-tree and the rays: positions and triangles only.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/scene/mesh.h"
#include "support/random_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace test {

struct SampleMesh {
    std::vector<rtcore::Vertex> vertices;
    std::vector<rtcore::Triangle> triangles;

    std::uint32_t addVertex(rtcore::Vec3 p) {
        vertices.push_back({p.x, p.y, p.z, 0});
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }
    void addTriangle(rtcore::Vec3 a, rtcore::Vec3 b, rtcore::Vec3 c) {
        const std::uint32_t first = addVertex(a);
        addVertex(b);
        addVertex(c);
        triangles.push_back({{first, first + 1, first + 2}});
    }
    /// Two triangles.
    void addQuad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        triangles.push_back({{a, b, c}});
        triangles.push_back({{a, c, d}});
    }
    void append(const SampleMesh& other) {
        const auto base = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const rtcore::Triangle& t : other.triangles) {
            triangles.push_back({{t.v[0] + base, t.v[1] + base, t.v[2] + base}});
        }
    }
    /// Every vertex becomes place(vertex).
    template <typename Place>
    SampleMesh& map(Place&& place) {
        for (rtcore::Vertex& v : vertices) {
            const rtcore::Vec3 p = place(v.position());
            v = {p.x, p.y, p.z, 0};
        }
        return *this;
    }
    SampleMesh& move(rtcore::Vec3 by) {
        return map([=](rtcore::Vec3 p) { return p + by; });
    }
    SampleMesh& scale(float by) {
        return map([=](rtcore::Vec3 p) { return p * by; });
    }
    /// About a random axis through the origin.
    SampleMesh& rotate(std::uint64_t seed) {
        Random random(seed);
        const rtcore::Vec3 z = random.unitVector();
        const rtcore::Basis side = rtcore::basisAround(z);
        return map([=](rtcore::Vec3 p) { return side.tangent * p.x + side.bitangent * p.y + z * p.z; });
    }

    /// Valid while this object lives and its vectors stay as they are.
    rtcore::Mesh view() const {
        rtcore::Mesh mesh;
        mesh.vertices = vertices;
        mesh.triangles = triangles;
        return mesh;
    }
};

/// `count` triangles of about `size`, anywhere in the cube [-1, 1]^3.
inline SampleMesh soup(std::size_t count, float size, std::uint64_t seed) {
    Random random(seed);
    SampleMesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        const rtcore::Vec3 p = random.vector(1);
        const rtcore::Vec3 a = p + random.vector(size);
        const rtcore::Vec3 b = p + random.vector(size);
        mesh.addTriangle(a, b, p + random.vector(size));
    }
    return mesh;
}

/// A flat square [-1, 1]^2 at `height` across `axis`, of 2 * side^2 triangles.
inline SampleMesh sheet(std::uint32_t side, int axis, float height) {
    SampleMesh mesh;
    for (std::uint32_t j = 0; j <= side; ++j) {
        for (std::uint32_t i = 0; i <= side; ++i) {
            rtcore::Vec3 p;
            p[axis] = height;
            p[(axis + 1) % 3] = 2 * static_cast<float>(i) / static_cast<float>(side) - 1;
            p[(axis + 2) % 3] = 2 * static_cast<float>(j) / static_cast<float>(side) - 1;
            mesh.addVertex(p);
        }
    }
    for (std::uint32_t j = 0; j < side; ++j) {
        for (std::uint32_t i = 0; i < side; ++i) {
            const std::uint32_t a = j * (side + 1) + i;
            mesh.addQuad(a, a + 1, a + side + 2, a + side + 1);
        }
    }
    return mesh;
}

/// The closed surface of the cube [-1, 1]^3, every face cut into side^2 squares: 12 * side^2 triangles.
inline SampleMesh boxGrid(int side) {
    SampleMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> known;
    const auto vertex = [&](std::array<int, 3> at) {
        const auto [entry, isNew] = known.try_emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (isNew) {
            rtcore::Vec3 p;
            for (int a = 0; a < 3; ++a) {
                p[a] = 2 * static_cast<float>(at[static_cast<std::size_t>(a)]) / static_cast<float>(side) - 1;
            }
            mesh.addVertex(p);
        }
        return entry->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const int face : {0, side}) {
            for (int j = 0; j < side; ++j) {
                for (int i = 0; i < side; ++i) {
                    const auto corner = [&](int di, int dj) {
                        std::array<int, 3> at{};
                        at[axis] = face;
                        at[(axis + 1) % 3] = i + di;
                        at[(axis + 2) % 3] = j + dj;
                        return vertex(at);
                    };
                    mesh.addQuad(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
                }
            }
        }
    }
    return mesh;
}

/// A closed unit sphere of 20 * 4^level triangles.
inline SampleMesh icosphere(int level) {
    SampleMesh mesh;
    const float g = (1 + std::sqrt(5.0F)) / 2;
    for (const rtcore::Vec3 p : {rtcore::Vec3{-1, g, 0},
                                 {1, g, 0},
                                 {-1, -g, 0},
                                 {1, -g, 0},
                                 {0, -1, g},
                                 {0, 1, g},
                                 {0, -1, -g},
                                 {0, 1, -g},
                                 {g, 0, -1},
                                 {g, 0, 1},
                                 {-g, 0, -1},
                                 {-g, 0, 1}}) {
        mesh.addVertex(normalize(p));
    }
    mesh.triangles = {{{0, 11, 5}}, {{0, 5, 1}},  {{0, 1, 7}},   {{0, 7, 10}}, {{0, 10, 11}},
                      {{1, 5, 9}},  {{5, 11, 4}}, {{11, 10, 2}}, {{10, 7, 6}}, {{7, 1, 8}},
                      {{3, 9, 4}},  {{3, 4, 2}},  {{3, 2, 6}},   {{3, 6, 8}},  {{3, 8, 9}},
                      {{4, 9, 5}},  {{2, 4, 11}}, {{6, 2, 10}},  {{8, 6, 7}},  {{9, 8, 1}}};
    for (int i = 0; i < level; ++i) {
        std::map<std::array<std::uint32_t, 2>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [entry, isNew] = middles.try_emplace({std::min(a, b), std::max(a, b)}, 0);
            if (isNew) {
                const rtcore::Vec3 sum = mesh.vertices[a].position() + mesh.vertices[b].position();
                entry->second = mesh.addVertex(normalize(sum));
            }
            return entry->second;
        };
        std::vector<rtcore::Triangle> finer;
        for (const rtcore::Triangle& t : mesh.triangles) {
            const std::uint32_t ab = middle(t.v[0], t.v[1]);
            const std::uint32_t bc = middle(t.v[1], t.v[2]);
            const std::uint32_t ca = middle(t.v[2], t.v[0]);
            for (const rtcore::Triangle part : {rtcore::Triangle{{t.v[0], ab, ca}},
                                                {{ab, t.v[1], bc}},
                                                {{ca, bc, t.v[2]}},
                                                {{ab, bc, ca}}}) {
                finer.push_back(part);
            }
        }
        mesh.triangles = std::move(finer);
    }
    return mesh;
}

/// A closed ring of radius 0.7 and thickness 0.3 around the z axis: 2 * around * across triangles.
inline SampleMesh torus(std::uint32_t around, std::uint32_t across) {
    SampleMesh mesh;
    const float turn = 2 * std::acos(-1.0F);
    for (std::uint32_t i = 0; i < around; ++i) {
        const float a = turn * static_cast<float>(i) / static_cast<float>(around);
        for (std::uint32_t j = 0; j < across; ++j) {
            const float b = turn * static_cast<float>(j) / static_cast<float>(across);
            const float r = 0.7F + 0.3F * std::cos(b);
            mesh.addVertex({r * std::cos(a), r * std::sin(a), 0.3F * std::sin(b)});
        }
    }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % around * across + j % across; };
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t j = 0; j < across; ++j) {
            mesh.addQuad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return mesh;
}

} // namespace test

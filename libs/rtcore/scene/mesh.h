/// All triangles of a scene as views on flat arrays: what rays are tested against apart from what shades
/// (thesis 4.1). The arrays belong to a Model (or to a mapped .bsp file) that must outlive the view.
#pragma once

#include "rtcore/math/box.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <cstdint>
#include <span>
#include <type_traits>

namespace rtcore {

/// 16 bytes, so that one aligned vector load fetches it. Neighbouring triangles share vertices, which makes
/// the ray test watertight: both see the same bits.
struct alignas(16) Vertex {
    float x = 0, y = 0, z = 0, unused = 0;

    Vec3 position() const { return {x, y, z}; }
    friend bool operator==(const Vertex&, const Vertex&) = default;
};
static_assert(sizeof(Vertex) == 16 && std::is_trivially_copyable_v<Vertex>);

/// Indices into `vertices`, counter-clockwise seen from the front.
struct Triangle {
    std::uint32_t v[3] = {0, 0, 0};
    friend bool operator==(const Triangle&, const Triangle&) = default;
};
static_assert(sizeof(Triangle) == 12);

/// Indices into `normals`, `texcoords`, `colours` and `alphas` (one index for all), and the material.
struct ShadingTriangle {
    std::uint32_t v[3] = {0, 0, 0};
    std::uint32_t material = 0;
    friend bool operator==(const ShadingTriangle&, const ShadingTriangle&) = default;
};
static_assert(sizeof(ShadingTriangle) == 16);

/// Sets of texture coordinates that a mesh may have beside the first.
inline constexpr std::size_t kMaxFurtherSets = 7;

struct Mesh {
    std::span<const Vertex> vertices;
    std::span<const Triangle> triangles;
    std::span<const ShadingTriangle> shading; ///< one per triangle
    std::span<const Vec3> normals;            ///< unit length
    std::span<const Vec2> texcoords; ///< empty, or as many as normals; (0,0) = lower left of the image
    std::span<const Colour> colours; ///< empty, or as many as normals; linear, multiplies the diffuse albedo
    std::span<const float> alphas = {}; ///< empty, or as many as normals; 0..1 (Material::vertexAlpha)
    /// Of further sets (Texture::texcoordSet): empty, or as many for each normal, one normal after another.
    std::span<const Vec2> furtherTexcoords = {};

    std::size_t furtherSets() const { return normals.empty() ? 0 : furtherTexcoords.size() / normals.size(); }
    /// `texcoords` is not empty, and `set` one of those that there are, counted from 0.
    Vec2 texcoord(std::uint32_t index, std::uint32_t set) const {
        return set == 0 ? texcoords[index] : furtherTexcoords[index * furtherSets() + set - 1];
    }

    Vec3 position(std::uint32_t triangle, int corner) const {
        return vertices[triangles[triangle].v[corner]].position();
    }
    /// Not normalised: its length is twice the area. Zero for a degenerate triangle.
    Vec3 geometricNormal(std::uint32_t triangle) const {
        const Vec3 a = position(triangle, 0);
        return cross(position(triangle, 1) - a, position(triangle, 2) - a);
    }
    Box3 bounds() const {
        Box3 box;
        for (const Triangle& t : triangles) {
            for (const std::uint32_t i : t.v) box.extend(vertices[i].position());
        }
        return box;
    }
};

} // namespace rtcore

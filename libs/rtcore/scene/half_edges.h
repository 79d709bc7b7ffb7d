/// Edges of triangles, and which of them two triangles share.
#pragma once

#include "rtcore/scene/mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

using Indices = std::vector<std::uint32_t>;

/// One side of one triangle: its end points ascending, and whether the triangle runs along them or against.
struct HalfEdge {
    std::uint32_t low, high;
    std::uint32_t triangle; ///< index into the list of triangles
    bool forward;

    bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

inline bool isDegenerate(const std::uint32_t* corners) {
    return corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
}

/// The corners of some triangles, three for each, and their materials.
Indices cornersOf(const Mesh& mesh, std::span<const std::uint32_t> triangles);
Indices materialsOf(const Mesh& mesh, std::span<const std::uint32_t> triangles);

/// Visits the sides of triangles, which have three corners each, or of those alone whose corners all differ.
template <class Visit>
void visitSides(std::span<const std::uint32_t> corners, bool degenerateOnes, const Visit& visit) {
    for (std::uint32_t i = 0; i < corners.size() / 3; ++i) {
        const std::uint32_t* const v = &corners[3 * std::size_t{i}];
        if (!degenerateOnes && isDegenerate(v)) continue;
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = v[corner], b = v[(corner + 1) % 3];
            visit(HalfEdge{std::min(a, b), std::max(a, b), i, a < b});
        }
    }
}

/// Those of one edge follow each other, triangles ascending.
std::vector<HalfEdge> halfEdges(std::span<const std::uint32_t> corners, bool degenerateOnes);

/// Calls `visit(sides)` for each edge with its half edges.
template <class Visit>
void visitEdges(std::span<HalfEdge> edges, const Visit& visit) {
    while (!edges.empty()) {
        std::size_t count = 1;
        while (count < edges.size() && edges[count].sameEdge(edges[0])) ++count;
        visit(edges.first(count));
        edges = edges.subspan(count);
    }
}

/// They are two that run against each other.
inline bool isPair(std::span<const HalfEdge> sides) {
    return sides.size() == 2 && sides[0].forward != sides[1].forward;
}

/// Whether the sides of one edge, ascending by triangle, are a pair of each of some materials, by triangle:
/// solids that touch there. Then the two of each follow each other, else they stay as they are.
bool sortIntoPairs(std::span<HalfEdge> sides, std::span<const std::uint32_t> materials);

/// Calls `visit(sides, paired)` for each edge, or each pair of one material where solids touch, and whether
/// they are two that run against each other.
template <class Visit>
void visitPairs(std::span<HalfEdge> edges, std::span<const std::uint32_t> materials, const Visit& visit) {
    visitEdges(edges, [&](std::span<HalfEdge> sides) {
        if (sides.size() <= 2 || !sortIntoPairs(sides, materials)) return visit(sides, isPair(sides));
        for (std::size_t i = 0; i < sides.size(); i += 2) visit(sides.subspan(i, 2), true);
    });
}

} // namespace rtcore

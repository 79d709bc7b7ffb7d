#include "rtcore/scene/half_edges.h"

#include <bit>
#include <numeric>
#include <tuple>
#include <utility>

namespace rtcore {

Indices cornersOf(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    Indices corners;
    corners.reserve(3 * triangles.size());
    for (const std::uint32_t t : triangles)
        corners.insert(corners.end(), mesh.triangles[t].v, mesh.triangles[t].v + 3);
    return corners;
}

Indices materialsOf(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    Indices materials;
    materials.reserve(triangles.size());
    for (const std::uint32_t t : triangles) materials.push_back(mesh.shading[t].material);
    return materials;
}

std::vector<HalfEdge> halfEdges(std::span<const std::uint32_t> corners, bool degenerateOnes) {
    // Counted by their lower end, few are left to be compared.
    const std::size_t mask = std::bit_ceil(corners.size() / 6 + 1) - 1;
    std::vector<std::size_t> end(mask + 2);
    visitSides(corners, degenerateOnes, [&](const HalfEdge& e) { ++end[(e.low & mask) + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<HalfEdge> edges(end.back());
    visitSides(corners, degenerateOnes, [&](const HalfEdge& e) { edges[end[e.low & mask]++] = e; });
    auto first = edges.begin();
    for (std::size_t bucket = 0; bucket <= mask; ++bucket) {
        const auto last = edges.begin() + static_cast<std::ptrdiff_t>(end[bucket]);
        std::sort(first, last, [](const HalfEdge& a, const HalfEdge& b) {
            return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
        });
        first = last;
    }
    return edges;
}

namespace {

bool arePairs(std::span<const HalfEdge> sides, std::span<const std::uint32_t> materials) {
    const auto materialOf = [&](std::size_t i) { return materials[sides[i].triangle]; };
    for (std::size_t i = 0; i < sides.size(); i += 2) {
        if (materialOf(i) != materialOf(i + 1) || !isPair(sides.subspan(i, 2))) return false;
        if (i > 0 && materialOf(i - 1) == materialOf(i)) return false;
    }
    return true;
}

} // namespace

bool sortIntoPairs(std::span<HalfEdge> sides, std::span<const std::uint32_t> materials) {
    if (sides.size() % 2 != 0) return false;
    const auto byTriangle = [](const HalfEdge& a, const HalfEdge& b) { return a.triangle < b.triangle; };
    std::sort(sides.begin(), sides.end(), [&](const HalfEdge& a, const HalfEdge& b) {
        return std::pair(materials[a.triangle], a.triangle) < std::pair(materials[b.triangle], b.triangle);
    });
    if (arePairs(sides, materials)) return true;
    std::sort(sides.begin(), sides.end(), byTriangle);
    return false;
}

} // namespace rtcore

#include "rtcore/scene/closed_surfaces.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rtcore {

namespace {

/// Disjoint sets with path halving.
class Parts {
  public:
    explicit Parts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[find(a)] = find(b); }

  private:
    std::vector<std::uint32_t> parent_;
};

/// One side of one triangle: its end points ascending, and whether the triangle runs along them or against.
struct HalfEdge {
    std::uint32_t low, high;
    std::uint32_t triangle; ///< index into the list of transparent triangles
    bool forward;

    bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

std::vector<HalfEdge> halfEdges(const Mesh& mesh, const std::vector<std::uint32_t>& triangles) {
    std::vector<HalfEdge> edges;
    edges.reserve(triangles.size() * 3);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[triangles[i]];
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t a = t.v[corner];
            const std::uint32_t b = t.v[(corner + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), i, a < b});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
    });
    return edges;
}

} // namespace

ClosedSurfaces findClosedSurfaces(const Mesh& mesh, std::span<const Material> materials) {
    if (std::none_of(materials.begin(), materials.end(), isTransparent)) return nullptr;
    std::vector<std::uint32_t> transparent;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (isTransparent(materials[mesh.shading[i].material])) transparent.push_back(i);
    }
    if (transparent.empty()) return nullptr;

    const std::vector<HalfEdge> edges = halfEdges(mesh, transparent);
    Parts parts(transparent.size());
    std::vector<std::uint8_t> openEdge(transparent.size());
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t last = first;
        while (last < edges.size() && edges[last].sameEdge(edges[first])) ++last;
        const bool paired = last - first == 2 && edges[first].forward != edges[first + 1].forward;
        for (std::size_t i = first; i < last; ++i) {
            parts.join(edges[i].triangle, edges[first].triangle);
            if (!paired) openEdge[edges[i].triangle] = 1;
        }
        first = last;
    }
    std::vector<std::uint8_t> openPart(transparent.size());
    for (std::uint32_t i = 0; i < transparent.size(); ++i) {
        if (openEdge[i] != 0) openPart[parts.find(i)] = 1;
    }
    std::vector<std::uint8_t> closed(mesh.triangles.size());
    for (std::uint32_t i = 0; i < transparent.size(); ++i) {
        closed[transparent[i]] = openPart[parts.find(i)] == 0 ? 1 : 0;
    }
    return std::make_shared<const std::vector<std::uint8_t>>(std::move(closed));
}

} // namespace rtcore

#include "rtcore/scene/closed_surfaces.h"

#include "rtcore/scene/half_edges.h"
#include "rtcore/scene/weld.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

namespace rtcore {

namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

/// The connected parts of triangles, and the open edges.
struct Closing {
    DisjointSets parts;
    std::vector<std::uint32_t> openEdges; ///< by triangle: those of its edges, of which it is the first

    explicit Closing(std::size_t triangles) : parts(triangles), openEdges(triangles) {}

    /// By triangle, whether its part has an open edge.
    std::vector<std::uint8_t> open() {
        std::vector<std::uint8_t> part(openEdges.size()), result(openEdges.size());
        for (std::uint32_t i = 0; i < openEdges.size(); ++i) {
            if (openEdges[i] != 0) part[parts.find(i)] = 1;
        }
        for (std::uint32_t i = 0; i < openEdges.size(); ++i) result[i] = part[parts.find(i)];
        return result;
    }
};

/// `materials` of the triangles: solids of different ones may touch.
Closing closingOf(std::size_t triangles, std::vector<HalfEdge> edges, const Indices& materials) {
    Closing closing(triangles);
    visitPairs(edges, materials, [&](std::span<const HalfEdge> sides, bool paired) {
        for (const HalfEdge& side : sides) closing.parts.join(side.triangle, sides[0].triangle);
        if (!paired) ++closing.openEdges[sides[0].triangle];
    });
    return closing;
}

/// Triangles of a mesh with points of their own: those of the mesh that they use, each once.
struct Piece {
    Piece(const Mesh& mesh, Indices which) : triangles(std::move(which)) {
        Indices number(mesh.vertices.size(), kNone);
        corners.reserve(3 * triangles.size());
        for (const std::uint32_t t : triangles) {
            for (const std::uint32_t v : mesh.triangles[t].v) {
                if (number[v] == kNone) {
                    number[v] = static_cast<std::uint32_t>(points.size());
                    points.push_back(mesh.vertices[v].position());
                }
                corners.push_back(number[v]);
            }
        }
    }
    /// Ends of open edges that differ by rounding alone become one.
    void weld() {
        std::vector<std::uint8_t> isEnd(points.size());
        std::vector<HalfEdge> edges = halfEdges(corners, true);
        visitEdges(edges, [&](std::span<const HalfEdge> sides) {
            if (!isPair(sides)) isEnd[sides[0].low] = isEnd[sides[0].high] = 1;
        });
        Indices ends;
        for (std::uint32_t i = 0; i < isEnd.size(); ++i) {
            if (isEnd[i] != 0) ends.push_back(i);
        }
        DisjointSets same = weldPoints(points, corners, ends);
        for (std::uint32_t& corner : corners) corner = same.find(corner);
    }
    Vec3d point(std::size_t triangle, std::size_t corner) const {
        const Vec3 p = points[corners[3 * triangle + corner]];
        return {p.x, p.y, p.z};
    }

    Indices triangles; ///< of the mesh
    Indices corners;   ///< of each three
    std::vector<Vec3> points;
};

/// By triangle, whether its part encloses next to nothing: two sheets back to back.
std::vector<std::uint8_t> emptyParts(const Piece& piece, DisjointSets& parts) {
    constexpr double kThinnest = 4e-6; // of the size of its surface
    struct Sum {
        double volume = 0, area = 0;
    };
    std::vector<Sum> sums(piece.triangles.size());
    for (std::uint32_t i = 0; i < sums.size(); ++i) {
        const std::uint32_t part = parts.find(i);
        const Vec3d origin = piece.point(part, 0);
        const Vec3d a = piece.point(i, 0) - origin, b = piece.point(i, 1) - origin,
                    c = piece.point(i, 2) - origin;
        sums[part].volume += dot(a, cross(b, c)) / 6;
        sums[part].area += length(cross(b - a, c - a)) / 2;
    }
    std::vector<std::uint8_t> empty(sums.size());
    for (std::uint32_t i = 0; i < sums.size(); ++i) {
        const Sum& sum = sums[parts.find(i)];
        empty[i] = std::fabs(sum.volume) <= kThinnest * sum.area * std::sqrt(sum.area) ? 1 : 0;
    }
    return empty;
}

/// The glass that is open, and its edges once it is welded.
struct OpenPiece {
    Piece piece;
    Closing closing;
    std::vector<std::uint8_t> open;
};

/// Triangles without edges of their own belong to those with edges that have their corners.
void joinDegenerateOnes(const Piece& piece, DisjointSets& parts) {
    Indices owner(piece.points.size(), kNone);
    visitSides(piece.corners, false, [&](const HalfEdge& e) { owner[e.low] = owner[e.high] = e.triangle; });
    for (std::uint32_t i = 0; i < piece.triangles.size(); ++i) {
        const std::uint32_t* const v = &piece.corners[3 * std::size_t{i}];
        if (!isDegenerate(v)) continue;
        for (int corner = 0; corner < 3; ++corner) {
            if (owner[v[corner]] != kNone) parts.join(i, owner[v[corner]]);
        }
    }
}

/// These triangles, and which do not close even when points that differ by rounding are one.
OpenPiece openWhenWelded(const Mesh& mesh, Indices triangles) {
    Piece piece(mesh, std::move(triangles));
    piece.weld();
    Closing closing = closingOf(piece.triangles.size(), halfEdges(piece.corners, false),
                                materialsOf(mesh, piece.triangles));
    joinDegenerateOnes(piece, closing.parts);
    std::vector<std::uint8_t> open = closing.open();
    const std::vector<std::uint8_t> empty = emptyParts(piece, closing.parts);
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = open[i] != 0 || empty[i] != 0 ? 1 : 0;
    return {std::move(piece), std::move(closing), std::move(open)};
}

/// All transparent triangles, and which of them are open as they are.
struct AsTheyAre {
    Indices transparent;
    std::vector<std::uint8_t> open;

    AsTheyAre(const Mesh& mesh, std::span<const Material> materials) {
        if (std::none_of(materials.begin(), materials.end(), isTransparent)) return;
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            if (isTransparent(materials[mesh.shading[i].material])) transparent.push_back(i);
        }
        open = closingOf(transparent.size(), halfEdges(cornersOf(mesh, transparent), true),
                         materialsOf(mesh, transparent))
                   .open();
    }
    /// Those of them that are glass.
    Indices openGlass(const Mesh& mesh, std::span<const Material> materials) const {
        Indices glass;
        for (std::size_t i = 0; i < transparent.size(); ++i) {
            if (open[i] != 0 && materials[mesh.shading[transparent[i]].material].opacity < 1)
                glass.push_back(transparent[i]);
        }
        return glass;
    }
};

struct Found {
    ClosedSurfaces closed;
    std::optional<OpenPiece> glass; ///< that was open as it is, if any
};

Found find(const Mesh& mesh, std::span<const Material> materials) {
    const AsTheyAre given(mesh, materials);
    if (given.transparent.empty()) return {};
    std::vector<std::uint8_t> closed(mesh.triangles.size());
    for (std::size_t i = 0; i < given.transparent.size(); ++i)
        closed[given.transparent[i]] = given.open[i] == 0 ? 1 : 0;
    Found found;
    if (Indices glass = given.openGlass(mesh, materials); !glass.empty()) {
        found.glass = openWhenWelded(mesh, std::move(glass));
        for (std::size_t i = 0; i < found.glass->open.size(); ++i)
            closed[found.glass->piece.triangles[i]] = found.glass->open[i] == 0 ? 1 : 0;
    }
    found.closed = std::make_shared<const std::vector<std::uint8_t>>(std::move(closed));
    return found;
}

} // namespace

std::vector<std::uint8_t> inClosedPieces(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    Closing closing(triangles.size());
    std::vector<HalfEdge> edges = halfEdges(cornersOf(mesh, triangles), true);
    visitEdges(edges, [&](std::span<const HalfEdge> sides) {
        for (const HalfEdge& side : sides) closing.parts.join(side.triangle, sides[0].triangle);
        const auto along = std::ranges::count_if(sides, &HalfEdge::forward);
        if (2 * along != std::ssize(sides)) ++closing.openEdges[sides[0].triangle];
    });
    std::vector<std::uint8_t> closed = closing.open();
    for (std::uint8_t& each : closed) each ^= 1U;
    return closed;
}

ClosedSurfaces findClosedSurfaces(const Mesh& mesh, std::span<const Material> materials) {
    return find(mesh, materials).closed;
}

ClosedSurfaces findClosedSurfaces(const Model& model, std::span<const Material> materials,
                                  std::vector<OpenGlass>& open) {
    const Found found = find(model.mesh, materials);
    open.clear();
    if (!found.glass) return found.closed;
    std::unordered_map<std::string_view, std::size_t> known;
    auto part = model.parts.begin();
    for (std::size_t i = 0; i < found.glass->open.size(); ++i) {
        if (found.glass->open[i] == 0) continue;
        const std::uint32_t t = found.glass->piece.triangles[i];
        while (part != model.parts.end() && part->firstTriangle + part->triangleCount <= t) ++part;
        const bool inPart = part != model.parts.end() && part->firstTriangle <= t;
        const std::string_view name = inPart ? model.name(part->nameOffset) : std::string_view();
        const auto [entry, isNew] = known.try_emplace(name, open.size());
        if (isNew) open.push_back({name});
        ++open[entry->second].triangles;
        open[entry->second].openEdges += found.glass->closing.openEdges[i];
    }
    return found.closed;
}

} // namespace rtcore

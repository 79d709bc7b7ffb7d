#include "rtcore/scene/glass_solids.h"

#include "rtcore/math/box.h"
#include "rtcore/scene/disjoint_sets.h"
#include "rtcore/scene/half_edges.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace rtcore {

namespace {

/// Comparisons of boxes at most: beyond, solids are taken to overlap, or to enclose no cavity.
constexpr std::size_t kMaxComparisons = 4'000'000;
constexpr std::uint32_t kNoShell = 0xFFFFFFFFU;

/// Connected triangles of closed glass.
struct Shell {
    std::uint32_t material = 0; ///< of its first triangle
    Box3 box;
    double volume = 0; ///< below 0: its front looks inwards, so that it is the wall of a cavity
};

bool encloses(const Box3& outer, const Box3& inner) {
    return outer.contains(inner.lo) && outer.contains(inner.hi);
}

struct Shells {
    Indices triangles; ///< of the glass
    Indices shellOf;   ///< of each of them
    std::vector<Shell> all;

    Shells(const Mesh& mesh, std::span<const Material> materials, const std::vector<std::uint8_t>& closed) {
        for (std::uint32_t t = 0; t < closed.size(); ++t) {
            if (closed[t] != 0 && materials[mesh.shading[t].material].opacity < 1) triangles.push_back(t);
        }
        DisjointSets parts(triangles.size());
        std::vector<HalfEdge> edges = halfEdges(cornersOf(mesh, triangles), false);
        visitPairs(edges, materialsOf(mesh, triangles), [&](std::span<const HalfEdge> sides, bool) {
            for (const HalfEdge& side : sides) parts.join(side.triangle, sides[0].triangle);
        });
        Indices number(triangles.size(), kNoShell);
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            std::uint32_t& shell = number[parts.find(i)];
            if (shell == kNoShell) {
                shell = static_cast<std::uint32_t>(all.size());
                all.push_back({mesh.shading[triangles[i]].material, {}, 0});
            }
            shellOf.push_back(shell);
            add(mesh, triangles[i], all[shell]);
        }
    }

    bool anyOverlap() const {
        Indices order(all.size());
        std::iota(order.begin(), order.end(), 0U);
        std::sort(order.begin(), order.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return all[a].box.lo.x < all[b].box.lo.x; });
        std::size_t comparisons = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Box3& box = all[order[i]].box;
            for (std::size_t k = i + 1; k < order.size() && all[order[k]].box.lo.x <= box.hi.x; ++k) {
                if (box.meets(all[order[k]].box) || ++comparisons > kMaxComparisons) return true;
            }
        }
        return false;
    }

    /// The material by which the medium of a shell goes: of a cavity's wall, that of the least solid around.
    std::uint32_t mediumOfShell(const Shell& shell) const {
        if (!(shell.volume < 0)) return shell.material;
        const Shell* around = nullptr;
        for (const Shell& each : all) {
            if (!(each.volume > 0) || !encloses(each.box, shell.box)) continue;
            if (each.material == shell.material) return shell.material;
            if (around == nullptr || each.box.halfArea() < around->box.halfArea()) around = &each;
        }
        return around != nullptr ? around->material : shell.material;
    }

  private:
    static void add(const Mesh& mesh, std::uint32_t triangle, Shell& shell) {
        std::array<Vec3d, 3> corners;
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = mesh.position(triangle, k);
            shell.box.extend(p);
            corners[static_cast<std::size_t>(k)] = {p.x, p.y, p.z};
        }
        // From a corner of the shell: far from zero nothing cancels.
        const Vec3 corner = shell.box.lo;
        const Vec3d origin{corner.x, corner.y, corner.z};
        shell.volume += dot(corners[0] - origin, cross(corners[1] - corners[0], corners[2] - corners[0]));
    }
};

/// Positions of the corners, ascending.
struct CornerKey {
    std::array<std::array<float, 3>, 3> corners;
    std::uint32_t triangle;
};

CornerKey keyOf(const Mesh& mesh, std::uint32_t triangle) {
    CornerKey key{{}, triangle};
    for (int k = 0; k < 3; ++k) {
        const Vec3 p = mesh.position(triangle, k);
        key.corners[static_cast<std::size_t>(k)] = {p.x, p.y, p.z};
    }
    std::sort(key.corners.begin(), key.corners.end());
    return key;
}

std::vector<GlassSolids::Twin> findTwins(const Mesh& mesh, const Indices& triangles,
                                         const std::vector<std::uint16_t>& medium) {
    std::vector<CornerKey> keys;
    keys.reserve(triangles.size());
    for (const std::uint32_t t : triangles) keys.push_back(keyOf(mesh, t));
    std::sort(keys.begin(), keys.end(), [](const CornerKey& a, const CornerKey& b) {
        return a.corners != b.corners ? a.corners < b.corners : a.triangle < b.triangle;
    });
    std::vector<GlassSolids::Twin> twins;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const std::uint32_t a = keys[i].triangle, b = keys[i + 1].triangle;
        if (keys[i].corners != keys[i + 1].corners || medium[a] == medium[b]) continue;
        const bool same = dot(mesh.geometricNormal(a), mesh.geometricNormal(b)) > 0;
        twins.push_back({a, b, same});
        twins.push_back({b, a, same});
        ++i;
    }
    std::sort(twins.begin(), twins.end(),
              [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
    return twins;
}

} // namespace

const GlassSolids::Twin* GlassSolids::twinOf(std::uint32_t triangle) const {
    const auto at = std::lower_bound(twins.begin(), twins.end(), triangle,
                                     [](const Twin& twin, std::uint32_t t) { return twin.triangle < t; });
    return at != twins.end() && at->triangle == triangle ? &*at : nullptr;
}

std::shared_ptr<const GlassSolids> findGlassSolids(const Mesh& mesh, std::span<const Material> materials,
                                                   const ClosedSurfaces& closed) {
    if (closed == nullptr) return nullptr;
    const Shells shells(mesh, materials, *closed);
    if (shells.all.empty()) return nullptr;
    auto solids = std::make_shared<GlassSolids>();
    solids->overlap = shells.anyOverlap();
    for (const Shell& shell : shells.all) solids->boxes.push_back(shell.box);
    const auto cavities = static_cast<std::size_t>(
        std::count_if(shells.all.begin(), shells.all.end(), [](const Shell& s) { return s.volume < 0; }));
    const bool few = cavities * shells.all.size() <= kMaxComparisons;
    std::vector<std::uint16_t> mediumOfShell;
    for (const Shell& shell : shells.all) {
        const std::uint32_t medium = 1 + (few ? shells.mediumOfShell(shell) : shell.material);
        const bool fits = medium <= std::numeric_limits<std::uint16_t>::max();
        mediumOfShell.push_back(fits ? static_cast<std::uint16_t>(medium) : std::uint16_t{0});
    }
    solids->medium.resize(closed->size());
    for (std::size_t i = 0; i < shells.triangles.size(); ++i)
        solids->medium[shells.triangles[i]] = mediumOfShell[shells.shellOf[i]];
    if (solids->overlap) solids->twins = findTwins(mesh, shells.triangles, solids->medium);
    return solids;
}

} // namespace rtcore

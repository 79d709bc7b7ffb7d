#include "rtcore/motion/nearby_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtcore {

namespace {

constexpr double kClose =
    0.1; ///< metres more than asked for in the small list, so that it serves a few steps
constexpr std::size_t kMany = 2048;

} // namespace

SolidTriangle solidTriangle(Vec3d a, Vec3d b, Vec3d c) {
    return {a,
            b,
            c,
            {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
             {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}},
            kNoTriangle};
}

void findTriangles(const KdTree& tree, const Box3& box, std::vector<std::uint32_t>& found) {
    found.clear();
    if (tree.nodes.empty()) return;
    std::uint32_t stack[kMaxKdDepth + 1];
    int waiting = 0;
    std::uint32_t at = 0;
    while (true) {
        const KdNode node = tree.nodes[at];
        if (node.isLeaf()) {
            const auto list =
                tree.references.subspan(node.count() > 0 ? node.firstReference : 0, node.count());
            found.insert(found.end(), list.begin(), list.end());
        } else {
            const bool lower = box.lo[node.axis()] <= node.split;
            const bool upper = box.hi[node.axis()] >= node.split;
            if (lower && upper) stack[waiting++] = node.lowerChild() + 1;
            if (lower || upper) {
                at = node.lowerChild() + (lower ? 0U : 1U);
                continue;
            }
        }
        if (waiting == 0) break;
        at = stack[--waiting];
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
}

NearbyTriangles::NearbyTriangles(const KdTree& tree, const Mesh& mesh, const WorldFrame& frame,
                                 double reserve)
    : tree_(tree), mesh_(mesh), frame_(frame), rounding_(0), reserve_(std::max(reserve, kClose)) {
    if (tree.bounds.empty()) return;
    for (int axis = 0; axis < 3; ++axis) {
        rounding_ = std::max({rounding_, std::fabs(tree.bounds.lo[axis]), std::fabs(tree.bounds.hi[axis])});
    }
    rounding_ *= 16 * std::numeric_limits<float>::epsilon();
}

Box3 NearbyTriangles::toScene(const Box3d& box) const {
    Box3 scene;
    for (int corner = 0; corner < 8; ++corner) {
        scene.extend(
            frame_.toScene({(corner & 1) != 0 ? box.hi.x : box.lo.x, (corner & 2) != 0 ? box.hi.y : box.lo.y,
                            (corner & 4) != 0 ? box.hi.z : box.lo.z}));
    }
    const Vec3 more{rounding_, rounding_, rounding_};
    return {scene.lo - more, scene.hi + more};
}

void NearbyTriangles::find(const Box3d& box) {
    known_ = box;
    findTriangles(tree_, toScene(box), indices_);
    found_.clear();
    for (const std::uint32_t i : indices_) {
        SolidTriangle t =
            solidTriangle(frame_.toMetres(mesh_.position(i, 0)), frame_.toMetres(mesh_.position(i, 1)),
                          frame_.toMetres(mesh_.position(i, 2)));
        t.number = i;
        if (isFinite(t.a) && isFinite(t.b) && isFinite(t.c) && t.box.overlaps(box)) found_.push_back(t);
    }
}

std::span<const SolidTriangle> NearbyTriangles::in(const Box3d& need) {
    if (close_.contains(need)) return triangles_;
    close_ = need.grown(kClose);
    if (!known_.contains(close_)) {
        find(dense_ ? close_ : need.grown(reserve_));
        dense_ = found_.size() > (dense_ ? kMany / 4 : kMany);
    }
    triangles_.clear();
    for (const SolidTriangle& t : found_) {
        if (t.box.overlaps(close_)) triangles_.push_back(t);
    }
    return triangles_;
}

} // namespace rtcore

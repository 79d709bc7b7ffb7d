#include "rtcore/motion/walk_surroundings.h"

#include "rtcore/kernels/section_clip.h"
#include "rtcore/kernels/single_ray.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rtcore {

namespace {

double lowestPoint(const KdTree& tree, const WorldFrame& frame) {
    if (tree.bounds.empty()) return 0;
    double lowest = frame.toMetres(tree.bounds.lo).z;
    for (int corner = 1; corner < 8; ++corner) {
        const Box3& b = tree.bounds;
        lowest = std::min(
            lowest, frame
                        .toMetres({(corner & 1) != 0 ? b.hi.x : b.lo.x, (corner & 2) != 0 ? b.hi.y : b.lo.y,
                                   (corner & 4) != 0 ? b.hi.z : b.lo.z})
                        .z);
    }
    return lowest;
}

} // namespace

WalkSurroundings::WalkSurroundings(const KdTree& tree, const Mesh& mesh, const WorldFrame& frame,
                                   const WalkShape& shape)
    : tree_(tree), mesh_(mesh), frame_(frame), shape_(shape), nearby_(tree, mesh, frame),
      nearLedge_(tree, mesh, frame, 0), lowest_(lowestPoint(tree, frame)) {}

void WalkSurroundings::useTree(const KdTree& tree) {
    tree_ = tree;
    nearby_.useTree(tree);
    nearLedge_.useTree(tree);
}

void WalkSurroundings::useSections(std::span<const SectionPlane> planes,
                                   std::span<const std::uint8_t> uncut) {
    cut_ = CutSurroundings(planes, uncut, frame_, double{roundingOf(tree_.bounds)}, shape_.walkable);
}

std::span<const SolidTriangle> WalkSurroundings::leftOf(std::span<const SolidTriangle> triangles, Vec3d feet,
                                                        std::vector<SolidTriangle>& left) const {
    if (cut_.empty()) return triangles;
    left.clear();
    for (const SolidTriangle& triangle : triangles) cut_.cut(triangle, feet, shape_.stand.step, left);
    return left;
}

void WalkSurroundings::gather(const WalkState& state, double move) {
    const Box3d here = body(std::max(state.height, shape_.stand.height)).box(state.feet);
    const double beside = move + kStepMargin;
    const Box3d box = here.grown({beside, beside, beside + shape_.stand.step});
    triangles_ = withUnseenFloor(leftOf(nearby_.in(box), state.feet, left_), box);
}

/// One triangle around the player, wherever it is: without edges near it.
std::span<const SolidTriangle> WalkSurroundings::withUnseenFloor(std::span<const SolidTriangle> triangles,
                                                                 const Box3d& box) {
    if (!unseenFloor_ || box.lo.z > lowest_ || box.hi.z < lowest_) return triangles;
    const double x = (box.lo.x + box.hi.x) / 2, y = (box.lo.y + box.hi.y) / 2;
    const double far = 10 * (box.hi.x - box.lo.x + box.hi.y - box.lo.y);
    const Vec3d a{x - 2 * far, y - far, lowest_}, b{x + 2 * far, y - far, lowest_},
        c{x, y + 2 * far, lowest_};
    withFloor_.assign(triangles.begin(), triangles.end());
    withFloor_.push_back({a, b, c, {{a.x, a.y, lowest_}, {b.x, c.y, lowest_}}, kNoTriangle});
    return withFloor_;
}

Body WalkSurroundings::climber(const WalkState& state, double top) {
    const Body b = body(state.height);
    Box3d way = b.box(state.feet);
    way.hi.z += top - state.feet.z;
    const auto there = nearLedge_.in(way.grown(b.reach() + 2 * kStepMargin));
    return {leftOf(there, state.feet, leftAtLedge_), shape_, state.height};
}

bool WalkSurroundings::sees(Vec3d from, Vec3d to) const {
    const Vec3 a = frame_.toScene(from), b = frame_.toScene(to);
    const auto [near, far] =
        cut_.leavesParts() ? std::pair(0.0, 1.0) : cut_.kept(from, to); // which may be in between
    return near > far ||
           !occluded(tree_, mesh_, {a, static_cast<float>(near), b - a, static_cast<float>(far)});
}

/// Under any part of the body.
bool WalkSurroundings::anythingBelow(Vec3d eye) const {
    const Vec3 down = frame_.turnBack(-Vec3d{0, 0, 1});
    for (const Vec3d aside : {Vec3d{}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}) {
        const Ray ray{frame_.toScene(eye + aside * shape_.radius), 0, down,
                      std::numeric_limits<float>::max()};
        if (occluded(tree_, mesh_, ray)) return true;
    }
    return false;
}

} // namespace rtcore

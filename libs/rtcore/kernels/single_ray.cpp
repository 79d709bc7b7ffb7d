#include "rtcore/kernels/single_ray.h"

#include "rtcore/kernels/watertight.h"

#include <array>
#include <cmath>

namespace rtcore {

namespace {

// Plane distances are (s - o) * (1 / d), three roundings; each is taken a little too small where an interval begins
// and too large where it ends (notes on errors: Ize 2013, "Robust BVH ray traversal").
constexpr float kDown = 1 - 6 * 0x1p-24F;
constexpr float kUp = 1 + 6 * 0x1p-24F;

/// A node that waits, with the part of the ray inside its cell.
struct Waiting {
    std::uint32_t node;
    float t0, t1;
};

struct Interval {
    float t0, t1;
};

/// The part of [tMin, tMax] inside the box. 0 * infinity (a ray inside a face, parallel to it) is NaN, which these
/// comparisons ignore: such a ray counts as inside.
bool clipToBox(const Box3& box, const Ray& ray, Vec3 inverse, Interval& interval) {
    interval = {ray.tMin, ray.tMax};
    for (int axis = 0; axis < 3; ++axis) {
        const float a = (box.lo[axis] - ray.origin[axis]) * inverse[axis];
        const float b = (box.hi[axis] - ray.origin[axis]) * inverse[axis];
        const float enter = std::signbit(inverse[axis]) ? b : a;
        const float leave = std::signbit(inverse[axis]) ? a : b;
        if (enter * kDown > interval.t0) interval.t0 = enter * kDown;
        if (leave * kUp < interval.t1) interval.t1 = leave * kUp;
    }
    return interval.t0 <= interval.t1;
}

/// Visits the leaves along the ray in order; `visit` gets each leaf and returns true to stop. `closest` is the
/// distance beyond which nothing matters any more.
template <typename Visit>
void traverse(const KdTree& tree, const Ray& ray, const float& closest, Visit&& visit) {
    const Vec3 inverse{1.0F / ray.direction.x, 1.0F / ray.direction.y, 1.0F / ray.direction.z};
    Interval interval{};
    if (tree.bounds.empty() || !clipToBox(tree.bounds, ray, inverse, interval)) return;
    const std::array<std::uint32_t, 3> nearIsUpper{std::signbit(inverse.x), std::signbit(inverse.y),
                                                   std::signbit(inverse.z)};
    std::array<Waiting, kMaxKdDepth> stack;
    std::size_t waiting = 0;
    std::uint32_t index = 0;
    while (true) {
        KdNode node = tree.nodes[index];
        while (!node.isLeaf()) {
            const int axis = node.axis();
            const float t = (node.split - ray.origin[axis]) * inverse[axis];
            const std::uint32_t near = node.lowerChild() + nearIsUpper[static_cast<std::size_t>(axis)];
            const std::uint32_t far = node.lowerChild() + 1 - nearIsUpper[static_cast<std::size_t>(axis)];
            // Inclusive: on equality, and for a ray inside the plane (NaN), both sides are visited.
            if (t > interval.t1) {
                index = near;
            } else if (t < interval.t0) {
                index = far;
            } else {
                const float begin = t * kDown;
                const float end = t * kUp;
                stack[waiting++] = {far, begin > interval.t0 ? begin : interval.t0, interval.t1};
                if (end < interval.t1) interval.t1 = end;
                index = near;
            }
            node = tree.nodes[index];
        }
        if (visit(node)) return;
        if (waiting == 0) return;
        --waiting;
        if (stack[waiting].t0 > closest) return;
        index = stack[waiting].node;
        interval = {stack[waiting].t0, stack[waiting].t1};
    }
}

} // namespace

bool intersect(const KdTree& tree, const Mesh& mesh, const Ray& ray, Hit& hit) {
    const RayShear shear(ray.direction);
    Hit best;
    best.t = ray.tMax;
    traverse(tree, ray, best.t, [&](const KdNode& leaf) {
        for (std::uint32_t i = 0; i < leaf.count(); ++i) {
            testTriangle(mesh, tree.references[leaf.firstReference + i], ray.origin, ray.tMin, shear, best);
        }
        return false;
    });
    if (best.triangle == kNoTriangle) return false;
    hit = best;
    return true;
}

bool occluded(const KdTree& tree, const Mesh& mesh, const Ray& ray) {
    const RayShear shear(ray.direction);
    Hit any;
    any.t = ray.tMax;
    bool found = false;
    traverse(tree, ray, ray.tMax, [&](const KdNode& leaf) {
        for (std::uint32_t i = 0; i < leaf.count() && !found; ++i) {
            found = testTriangle(mesh, tree.references[leaf.firstReference + i], ray.origin, ray.tMin, shear, any);
        }
        return found;
    });
    return found;
}

} // namespace rtcore

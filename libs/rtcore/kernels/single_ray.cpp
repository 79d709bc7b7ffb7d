#include "rtcore/kernels/single_ray.h"

#include "rtcore/kernels/watertight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtcore {

namespace {

// Plane distances are (s - o) * (1 / d), three roundings; each is taken a little too small where an interval
// begins and too large where it ends (notes on errors: Ize 2013, "Robust BVH ray traversal").
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

/// By how much the distance of a hit may be off from where the tree says that its cell lies: the leaf test's
/// error grows with the distance of a triangle's farthest corner (kDistanceError), which is at most that of
/// the box.
float slackOf(const Box3& box, const Ray& ray) {
    Vec3 farthest;
    for (int axis = 0; axis < 3; ++axis) {
        farthest[axis] =
            std::max(std::fabs(box.lo[axis] - ray.origin[axis]), std::fabs(box.hi[axis] - ray.origin[axis]));
    }
    return kDistanceError * std::sqrt(dot(farthest, farthest) / dot(ray.direction, ray.direction));
}

/// The part of [tMin, tMax + slack] inside the box. 0 * infinity (a ray inside a face, parallel to it) is
/// NaN, which these comparisons ignore: such a ray counts as inside.
[[gnu::always_inline]] inline bool clipToBox(const Box3& box, const Ray& ray, float slack, Vec3 inverse,
                                             Interval& interval) {
    interval = {ray.tMin, ray.tMax + slack};
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

/// Visits the leaves along the ray in order; `visit` gets each leaf and returns true to stop. `closest` is
/// the distance beyond which nothing matters any more.
template <typename Visit>
void traverse(const KdTree& tree, const Ray& ray, const float& closest, Visit&& visit) {
    const Vec3 inverse{1.0F / ray.direction.x, 1.0F / ray.direction.y, 1.0F / ray.direction.z};
    Interval interval{};
    if (tree.bounds.empty()) return;
    const float slack = slackOf(tree.bounds, ray);
    if (!clipToBox(tree.bounds, ray, slack, inverse, interval)) return;
    // Bit 4 i + axis is set when the upper child is the nearer one: a shift by all of a node's bits finds it
    // without waiting for the axis.
    const std::uint32_t signs = (std::signbit(inverse.x) ? 1U : 0U) | (std::signbit(inverse.y) ? 2U : 0U) |
                                (std::signbit(inverse.z) ? 4U : 0U);
    const std::uint32_t nearIsUpper = signs * 0x11111111U;
    // Arrays, since the axis of a node is not known in advance.
    const std::array<float, 3> origin{ray.origin.x, ray.origin.y, ray.origin.z};
    const std::array<float, 3> scale{inverse.x, inverse.y, inverse.z};
    const KdNode* const nodes = tree.nodes.data();
    std::array<Waiting, kMaxKdDepth> stack;
    std::size_t waiting = 0;
    std::uint32_t index = 0;
    while (true) {
        KdNode node = nodes[index];
        while (!node.isLeaf()) {
            const auto axis = static_cast<std::size_t>(node.axis());
            const float t = (node.split - origin[axis]) * scale[axis];
            const std::uint32_t upperFirst = nearIsUpper >> (node.bits & 31U) & 1U;
            const std::uint32_t near = node.lowerChild() + upperFirst;
            const std::uint32_t far = node.lowerChild() + 1 - upperFirst;
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
            node = nodes[index];
        }
        if (visit(node)) return;
        // Those behind the closest hit are passed over one by one: where the ray lies in a plane, both sides
        // begin at once, so that what waits below may begin before what waits above it.
        do {
            if (waiting == 0) return;
            --waiting;
        } while (stack[waiting].t0 - slack > closest);
        index = stack[waiting].node;
        interval = {stack[waiting].t0, stack[waiting].t1};
    }
}

} // namespace

bool intersect(const KdTree& tree, const Mesh& mesh, const Ray& ray, Hit& hit) {
    const RayShear shear(ray.direction);
    Hit best;
    best.t = ray.tMax;
    alongAxis(shear.kz, [&](auto kz) {
        traverse(tree, ray, best.t, [&](const KdNode& leaf) {
            const std::uint32_t* const references = tree.references.data() + leaf.firstReference;
            for (std::uint32_t i = 0; i < leaf.count(); ++i) {
                testTriangle<kz>(mesh, references[i], ray, shear, best);
            }
            return false;
        });
    });
    if (best.triangle == kNoTriangle) return false;
    hit = best;
    return true;
}

bool occluded(const KdTree& tree, const Mesh& mesh, const Ray& ray) {
    const RayShear shear(ray.direction);
    Hit any;
    any.t = ray.tMax;
    alongAxis(shear.kz, [&](auto kz) {
        traverse(tree, ray, ray.tMax, [&](const KdNode& leaf) {
            const std::uint32_t* const references = tree.references.data() + leaf.firstReference;
            for (std::uint32_t i = 0; i < leaf.count(); ++i) {
                if (testTriangle<kz>(mesh, references[i], ray, shear, any)) return true;
            }
            return false;
        });
    });
    return any.triangle != kNoTriangle;
}

} // namespace rtcore

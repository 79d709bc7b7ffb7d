#include "rtcore/kernels/single_ray.h"

#include "rtcore/kernels/hit_distance.h"
#include "rtcore/kernels/rounding.h"
#include "rtcore/kernels/watertight.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rtcore {

namespace {

TriangleCorners cornersOf(const KernelScene& scene, std::uint32_t reference) {
    const std::uint32_t index = scene.references[reference];
    const Triangle& t = scene.triangles[index];
    return {scene.vertices[t.v[0]], scene.vertices[t.v[1]], scene.vertices[t.v[2]], index};
}

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
float slackOf(const KernelScene& scene, const Ray& ray) {
    float far = 0;
    float length = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float o = ray.origin[axis];
        far += std::max(std::fabs(scene.lo[axis] - o), std::fabs(scene.hi[axis] - o));
        length = std::max(length, std::fabs(ray.direction[axis]));
    }
    return kDistanceError * far / length;
}

/// The part of [tMin - slack, tMax + slack] inside the box, nothing of it behind the origin. 0 * infinity (a
/// ray inside a face, parallel to it) is NaN, which these comparisons ignore: such a ray counts as inside.
[[gnu::always_inline]] inline bool clipToBox(const KernelScene& scene, const Ray& ray, float slack,
                                             Vec3 inverse, Interval& interval) {
    interval = {std::max(ray.tMin - slack, 0.0F), ray.tMax + slack};
    for (int axis = 0; axis < 3; ++axis) {
        const float a = (scene.lo[axis] - ray.origin[axis]) * inverse[axis];
        const float b = (scene.hi[axis] - ray.origin[axis]) * inverse[axis];
        const float enter = std::signbit(inverse[axis]) ? b : a;
        const float leave = std::signbit(inverse[axis]) ? a : b;
        if (enter * kPlaneDown > interval.t0) interval.t0 = enter * kPlaneDown;
        if (leave * kPlaneUp < interval.t1) interval.t1 = leave * kPlaneUp;
    }
    return interval.t0 <= interval.t1;
}

/// Visits the leaves along the ray in order; `visit` gets each leaf and returns true to stop. `closest` is
/// the distance beyond which nothing matters any more.
template <typename Visit>
void traverse(const KernelScene& scene, const Ray& ray, const float& closest, Visit&& visit) {
    const Vec3 inverse{1.0F / ray.direction.x, 1.0F / ray.direction.y, 1.0F / ray.direction.z};
    Interval interval{};
    if (!(scene.lo[0] <= scene.hi[0])) return;
    const float slack = slackOf(scene, ray);
    if (!clipToBox(scene, ray, slack, inverse, interval)) return;
    // Bit 4 i + axis is set when the upper child is the nearer one: a shift by all of a node's bits finds it
    // without waiting for the axis.
    const std::uint32_t signs = (std::signbit(inverse.x) ? 1U : 0U) | (std::signbit(inverse.y) ? 2U : 0U) |
                                (std::signbit(inverse.z) ? 4U : 0U);
    const std::uint32_t nearIsUpper = signs * 0x11111111U;
    // Arrays, since the axis of a node is not known in advance.
    const std::array<float, 3> origin{ray.origin.x, ray.origin.y, ray.origin.z};
    const std::array<float, 3> scale{inverse.x, inverse.y, inverse.z};
    const KdNode* const nodes = scene.nodes;
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
            const float begin = t * kPlaneDown;
            const float end = t * kPlaneUp;
            if (begin > interval.t1) {
                index = near;
            } else if (end < interval.t0) {
                index = far;
            } else {
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

/// Tests the triangles of a leaf; with `kAny`, true at the first hit.
template <int kz, bool kAny>
[[gnu::always_inline]] inline bool testLeaf(const KernelScene& scene, const KdNode& leaf, const Ray& ray,
                                            const RayShear& shear, std::uint32_t startTriangle, Hit& best) {
    for (std::uint32_t i = 0; i < leaf.count(); ++i) {
        const TriangleCorners corners = cornersOf(scene, leaf.firstReference + i);
        if (corners.index == startTriangle) continue;
        if (kAny && scene.clear != nullptr && scene.letsThrough(corners.index)) continue;
        Hit hit = best;
        if (!testTriangle<kz>(corners, ray, shear, hit)) continue;
        if (!scene.filter.empty() && !scene.filter.keeps(hit.triangle, hit.u, hit.v)) continue;
        best = hit;
        if (kAny) return true;
    }
    return false;
}

template <bool kAny>
bool find(const KernelScene& scene, const Ray& ray, std::uint32_t startTriangle, Hit& hit) {
    const RayShear shear(ray.direction);
    Hit best;
    best.t = ray.tMax;
    alongAxis(shear.kz, [&](auto kz) {
        traverse(scene, ray, best.t, [&](const KdNode& leaf) {
            return testLeaf<kz, kAny>(scene, leaf, ray, shear, startTriangle, best);
        });
    });
    if (best.triangle == kNoTriangle) return false;
    hit = best;
    return true;
}

} // namespace

bool findClosest(const KernelScene& scene, const Ray& ray, Hit& hit, std::uint32_t startTriangle) {
    return find<false>(scene, ray, startTriangle, hit);
}

bool findAny(const KernelScene& scene, const Ray& ray, std::uint32_t startTriangle) {
    Hit any;
    return find<true>(scene, ray, startTriangle, any);
}

bool intersect(const KdTree& tree, const Mesh& mesh, const Ray& ray, Hit& hit) {
    if (!findClosest({tree, mesh}, ray, hit)) return false;
    if (isNear(ray, hit, nearLimit(tree.bounds))) refineDistance(mesh, ray, hit);
    return true;
}

bool occluded(const KdTree& tree, const Mesh& mesh, const Ray& ray) { return findAny({tree, mesh}, ray); }

} // namespace rtcore

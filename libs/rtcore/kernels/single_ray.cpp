#include "rtcore/kernels/single_ray.h"

#include "rtcore/kernels/hit_distance.h"
#include "rtcore/kernels/one_surface.h"
#include "rtcore/kernels/rounding.h"
#include "rtcore/kernels/watertight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

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

/// By how much the distance of a hit may be off from where the tree says that its cell lies, or that of
/// another surface in its plane.
float slackOf(const KernelScene& scene, const Ray& ray) {
    float far = 0;
    float length = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float o = ray.origin[axis];
        far += std::max(std::fabs(scene.lo[axis] - o), std::fabs(scene.hi[axis] - o));
        length = std::max(length, std::fabs(ray.direction[axis]));
    }
    return kDistanceError * (far + scene.size) / length;
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

/// A ray that is prepared for the tests of leaves.
struct HitSearch {
    HitSearch(const KernelScene& in, const Ray& along, const NarrowTriangles* known = nullptr)
        : scene(in), narrow(known), ray(along), shear(along.direction) {
        ray.tMax = std::min(ray.tMax, kFarthestHit);
    }

    const KernelScene& scene;
    const NarrowTriangles* narrow; ///< null: to be found out
    Ray ray;
    RayShear shear;

    /// Calls `use` with each hit of a triangle in the leaf from ray.tMin to `farthest`, until it returns
    /// true.
    template <int kz, typename Use>
    [[gnu::always_inline]] bool eachHit(const KdNode& leaf, const float& farthest, Use&& use) const {
        const auto noiseOf = [&](const TriangleCorners& of) {
            return narrow != nullptr ? narrow->noiseOf(of.index) : noiseByCorners(of);
        };
        for (std::uint32_t i = 0; i < leaf.count(); ++i) {
            const TriangleCorners corners = cornersOf(scene, leaf.firstReference + i);
            Hit hit;
            hit.t = farthest;
            if (!testTriangle<kz>(corners, ray, shear, hit, noiseOf)) continue;
            if (!scene.filter.empty() && !scene.filter.keeps(hit.triangle, hit.u, hit.v)) continue;
            if (use(hit)) return true;
        }
        return false;
    }
    /// The same along the ray, up to ray.tMax. `closest`: beyond it nothing matters.
    template <typename Use>
    void eachHitAlong(const float& closest, const float& farthest, Use&& use) const {
        alongAxis(shear.kz, [&](auto kz) {
            traverse(scene, ray, closest,
                     [&](const KdNode& leaf) { return eachHit<kz>(leaf, farthest, use); });
        });
    }
};

/// Hits that are no further apart may be on one surface.
float tieOf(const KernelScene& scene, const Ray& ray) { return slackOf(scene, ray) * kTieFraction; }

/// Different hits, as many as there is room for.
class FewHits {
  public:
    void add(const Hit& hit) {
        const auto known = hits();
        if (std::ranges::find(known, hit.triangle, &Hit::triangle) != known.end()) return;
        if (count_ < hits_.size()) hits_[count_] = hit;
        ++count_;
    }
    bool complete() const { return count_ <= hits_.size(); }
    std::span<const Hit> hits() const { return std::span(hits_).first(std::min(count_, hits_.size())); }

  private:
    std::array<Hit, 8> hits_;
    std::size_t count_ = 0;
};

SurfacePlane planeOf(const KernelScene& scene, std::uint32_t triangle) {
    const Triangle& t = scene.triangles[triangle];
    return {scene.vertices[t.v[0]].position(), scene.vertices[t.v[1]].position(),
            scene.vertices[t.v[2]].position()};
}

} // namespace

bool findNearest(const KernelScene& scene, const Ray& ray, Hit& hit) {
    const float tie = tieOf(scene, ray);
    const HitSearch search(scene, ray);
    Hit best;
    best.t = search.ray.tMax;
    float farthest = best.t + tie;
    search.eachHitAlong(best.t, farthest, [&](const Hit& found) {
        if (found.triangle == best.triangle) return false; // met in another leaf before
        const bool tied = found.t >= best.t - tie;
        best = {std::min(best.t, found.t), tied ? found.triangle | kTiedHit : found.triangle, found.u,
                found.v};
        farthest = best.t + tie;
        return false;
    });
    if (best.triangle == kNoTriangle) return false;
    hit = best;
    return true;
}

std::optional<float> settleTie(const KernelScene& scene, const NarrowTriangles* narrow, const Ray& ray,
                               Hit& hit) {
    HitSearch search(scene, ray, narrow);
    search.ray.tMin = hit.t;
    search.ray.tMax = std::min(hit.t + tieOf(scene, ray), search.ray.tMax);
    const auto eachTie = [&](auto&& use) {
        search.eachHitAlong(search.ray.tMax, search.ray.tMax, [&](const Hit& found) {
            use(found);
            return false;
        });
    };
    FewHits ties;
    Hit nearest;
    eachTie([&](const Hit& found) {
        if (found.t == hit.t && found.triangle < nearest.triangle) nearest = found;
        ties.add(found);
    });
    if (nearest.triangle == kNoTriangle) return std::nullopt;
    hit = nearest;
    const SurfacePlane plane = planeOf(scene, nearest.triangle);
    const MetSurface surface(plane, ray);
    float clearance = 0;
    float gap = 0; // between the nearest and the chosen one
    const auto choose = [&](const Hit& found) {
        if (found.triangle == nearest.triangle) return;
        const SurfacePlane other = planeOf(scene, found.triangle);
        if (!surface.has(other)) return;
        clearance = std::max(clearance, surface.gapTo(other) + other.clearance);
        if (found.triangle > hit.triangle) return;
        hit = found;
        gap = surface.gapTo(other);
    };
    if (ties.complete()) {
        for (const Hit& found : ties.hits()) choose(found);
    } else {
        eachTie(choose);
    }
    return hit.triangle == nearest.triangle ? clearance : std::max(clearance, plane.clearance) + gap;
}

bool findClosest(const KernelScene& scene, const Ray& ray, Hit& hit) {
    Hit found;
    if (!findNearest(scene, ray, found)) return false;
    if ((found.triangle & kTiedHit) != 0 && !settleTie(scene, nullptr, ray, found)) return false;
    hit = found;
    return true;
}

bool findAny(const KernelScene& scene, const Ray& ray) {
    bool any = false;
    const HitSearch search(scene, ray);
    search.eachHitAlong(search.ray.tMax, search.ray.tMax, [&](const Hit& found) {
        any = scene.clear == nullptr || !scene.letsThrough(found.triangle);
        return any;
    });
    return any;
}

bool intersect(const KdTree& tree, const Mesh& mesh, const Ray& ray, Hit& hit) {
    if (!findClosest({tree, mesh}, ray, hit)) return false;
    if (isNear(ray, hit, nearLimit(tree.bounds))) refineDistance(mesh, ray, hit);
    return true;
}

bool occluded(const KdTree& tree, const Mesh& mesh, const Ray& ray) { return findAny({tree, mesh}, ray); }

} // namespace rtcore

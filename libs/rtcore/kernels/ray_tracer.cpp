#include "rtcore/kernels/ray_tracer.h"

#include "rtcore/accel/tree_within.h"
#include "rtcore/accel/visible_tree.h"
#include "rtcore/kernels/clip_rays.h"
#include "rtcore/kernels/hit_distance.h"
#include "rtcore/kernels/leaf_records.h"
#include "rtcore/kernels/single_ray.h"
#include "rtcore/kernels/wave_kernels.h"

#include <memory>
#include <utility>

namespace rtcore {

namespace {

/// A thread's working memory. It lives as long as the thread: the pages of a fresh one cost more than a wave.
struct ThreadMemory {
    StreamScratch streams;
    std::vector<std::uint32_t> indices; ///< of some of a wave's rays
    std::vector<float> tMin, tMax;      ///< of clipped rays
};

ThreadMemory& threadMemory() {
    static thread_local const auto memory = std::make_unique<ThreadMemory>();
    return *memory;
}

RaySpan spanOf(const RayWave& rays) {
    return {{rays.ox.data(), rays.oy.data(), rays.oz.data()},
            {rays.dx.data(), rays.dy.data(), rays.dz.data()},
            rays.tMin.data(),
            rays.tMax.data(),
            rays.size()};
}

RaySpan spanWithin(std::span<const HalfSpace> halves, const RayWave& rays, ThreadMemory& memory) {
    const RaySpan span = spanOf(rays);
    if (halves.empty()) return span;
    memory.tMin.resize(rays.size());
    memory.tMax.resize(rays.size());
    return clipRays(halves, span, memory.tMin.data(), memory.tMax.data());
}

} // namespace

LeafRecords chooseLeafRecords(const KdTree& tree, std::uint64_t expectedRays) {
    constexpr std::uint64_t kLargest = 1U << 30U;
    const std::uint64_t references = tree.references.size();
    const bool few = expectedRays > 0 && expectedRays < 2 * references;
    const bool large = references * kFloatsPerRecord * sizeof(float) > kLargest;
    return few || large ? LeafRecords::Shared : LeafRecords::Inline;
}

KdRayTracer::KdRayTracer(const KdTree& tree, const Mesh& mesh, LeafRecords records)
    : KdRayTracer(tree, mesh, NarrowTriangles(tree, mesh), records) {}

KdRayTracer::KdRayTracer(const KdTree& tree, const KdRayTracer& whole)
    : KdRayTracer(tree, whole.mesh_, NarrowTriangles(tree, whole.leaves_->narrow.noise),
                  LeafRecords::Shared) {}

KdRayTracer::KdRayTracer(const KdTree& tree, const Mesh& mesh, NarrowTriangles narrow, LeafRecords records)
    : KdRayTracer(tree, mesh, makeLeaves(tree, mesh, std::move(narrow), records)) {}

std::shared_ptr<const KdRayTracer::Leaves>
KdRayTracer::makeLeaves(const KdTree& tree, const Mesh& mesh, NarrowTriangles narrow, LeafRecords records) {
    auto leaves = std::make_shared<Leaves>(Leaves{std::move(narrow), {}});
    if (records == LeafRecords::Inline) {
        const NarrowTriangles& known = leaves->narrow;
        leaves->records =
            makeLeafRecords(tree, known.bits.empty() ? tree.references : known.references, mesh);
    }
    return leaves;
}

KdRayTracer::KdRayTracer(const KdTree& tree, const Mesh& mesh, std::shared_ptr<const Leaves> leaves)
    : tree_(tree), mesh_(mesh), leaves_(std::move(leaves)),
      scene_(tree_, mesh_, leaves_->records.capacity() == 0 ? nullptr : leaves_->records.data(),
             &leaves_->narrow),
      nearLimit_(nearLimit(tree.bounds)) {}

std::size_t KdRayTracer::memory() const {
    const NarrowTriangles& narrow = leaves_->narrow;
    return tree_.nodes.size_bytes() + tree_.references.size_bytes() +
           leaves_->records.capacity() * sizeof(float) + std::span(narrow.noise).size_bytes() +
           std::span(narrow.references).size_bytes() + std::span(narrow.bits).size_bytes();
}

void KdRayTracer::intersect(RayKind /*kind*/, const RayWave& rays, HitWave& hits) const {
    hits.resize(rays.size());
    ThreadMemory& memory = threadMemory();
    const RaySpan span = spanWithin(halves_, rays, memory);
    const HitSpan found{hits.t.data(), hits.triangle.data(), hits.u.data(), hits.v.data()};
    traceClosest(scene_, span, memory.streams, found);
    memory.indices.resize(rays.size());
    std::uint32_t* const indices = memory.indices.data();
    settleTies(span, {indices, findTied(found, rays.size(), indices)}, hits);
    const std::size_t near = findNear(span, found, nearLimit_, indices);
    for (std::size_t i = 0; i < near; ++i) {
        const std::uint32_t ray = indices[i];
        Hit hit = hits.hit(ray);
        refineDistance(mesh_, leaves_->narrow.noiseOf(hit.triangle), span.ray(ray), hit);
        hits.t[ray] = hit.t;
    }
}

void KdRayTracer::settleTies(const RaySpan& rays, std::span<const std::uint32_t> tied, HitWave& hits) const {
    if (tied.empty()) return;
    hits.clearance.assign(rays.count, 0);
    for (const std::uint32_t i : tied) {
        Hit hit = hits.hit(i);
        const auto clearance = settleTie(scene_, &leaves_->narrow, rays.ray(i), hit);
        if (!clearance) hit = {};
        hits.set(i, hit);
        hits.clearance[i] = clearance.value_or(0);
    }
}

void KdRayTracer::occluded(RayKind /*kind*/, const RayWave& rays, std::vector<std::uint8_t>& occluded) const {
    occluded.resize(rays.size());
    ThreadMemory& memory = threadMemory();
    traceAny(scene_, spanWithin(halves_, rays, memory), memory.streams, occluded.data());
}

void RayTracer::findObstacles(const RayWave& rays, std::span<const std::uint8_t> /*clear*/,
                              std::vector<Obstacle>& found) const {
    found.assign(rays.size(), Obstacle::Unknown);
}

std::shared_ptr<const RayTracer> RayTracer::without(std::span<const std::uint8_t> /*left*/) const {
    return nullptr;
}

std::shared_ptr<const RayTracer> KdRayTracer::without(std::span<const std::uint8_t> left) const {
    auto tracer = std::make_shared<KdRayTracer>(visibleTree(tree_, left), *this);
    tracer->scene_.filter = scene_.filter;
    tracer->halves_ = halves_;
    return tracer;
}

std::shared_ptr<const RayTracer> RayTracer::within(std::span<const HalfSpace> /*halves*/) const {
    return nullptr;
}

std::shared_ptr<const RayTracer> KdRayTracer::within(std::span<const HalfSpace> halves) const {
    const std::shared_ptr<KdRayTracer> tracer(new KdRayTracer(treeWithin(tree_, halves), mesh_, leaves_));
    tracer->scene_.filter = scene_.filter;
    tracer->halves_ = halves_;
    tracer->halves_.insert(tracer->halves_.end(), halves.begin(), halves.end());
    return tracer;
}

void KdRayTracer::findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                                std::vector<Obstacle>& found) const {
    static_assert(static_cast<int>(Obstacle::None) == 0 && static_cast<int>(Obstacle::Opaque) == 1 &&
                  static_cast<int>(Obstacle::Unknown) == 2);
    found.resize(rays.size());
    KernelScene scene = scene_;
    scene.clear = clear.data();
    ThreadMemory& memory = threadMemory();
    traceAny(scene, spanWithin(halves_, rays, memory), memory.streams,
             reinterpret_cast<std::uint8_t*>(found.data()));
}

} // namespace rtcore

#include "rtcore/kernels/ray_tracer.h"

#include "rtcore/accel/visible_tree.h"
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
    : KdRayTracer(tree, whole.mesh_, NarrowTriangles(tree, whole.narrow_.noise), LeafRecords::Shared) {}

KdRayTracer::KdRayTracer(const KdTree& tree, const Mesh& mesh, NarrowTriangles narrow, LeafRecords records)
    : tree_(tree), mesh_(mesh), narrow_(std::move(narrow)),
      records_(records == LeafRecords::Inline
                   ? makeLeafRecords(tree, narrow_.bits.empty() ? tree.references : narrow_.references, mesh)
                   : UninitializedArray<float>{}),
      scene_(tree_, mesh_, records_.capacity() == 0 ? nullptr : records_.data(), &narrow_),
      nearLimit_(nearLimit(tree.bounds)) {}

std::size_t KdRayTracer::memory() const {
    return tree_.nodes.size_bytes() + tree_.references.size_bytes() + records_.capacity() * sizeof(float) +
           std::span(narrow_.noise).size_bytes() + std::span(narrow_.references).size_bytes() +
           std::span(narrow_.bits).size_bytes();
}

void KdRayTracer::intersect(RayKind /*kind*/, const RayWave& rays, HitWave& hits) const {
    hits.resize(rays.size());
    const RaySpan span = spanOf(rays);
    const HitSpan found{hits.t.data(), hits.triangle.data(), hits.u.data(), hits.v.data()};
    ThreadMemory& memory = threadMemory();
    traceClosest(scene_, span, memory.streams, found);
    memory.indices.resize(rays.size());
    std::uint32_t* const indices = memory.indices.data();
    settleTies(rays, {indices, findTied(found, rays.size(), indices)}, hits);
    const std::size_t near = findNear(span, found, nearLimit_, indices);
    for (std::size_t i = 0; i < near; ++i) {
        const std::uint32_t ray = indices[i];
        Hit hit = hits.hit(ray);
        refineDistance(mesh_, narrow_.noiseOf(hit.triangle), rays.ray(ray), hit);
        hits.t[ray] = hit.t;
    }
}

void KdRayTracer::settleTies(const RayWave& rays, std::span<const std::uint32_t> tied, HitWave& hits) const {
    if (tied.empty()) return;
    hits.clearance.assign(rays.size(), 0);
    for (const std::uint32_t i : tied) {
        Hit hit = hits.hit(i);
        const auto clearance = settleTie(scene_, &narrow_, rays.ray(i), hit);
        if (!clearance) hit = {};
        hits.set(i, hit);
        hits.clearance[i] = clearance.value_or(0);
    }
}

void KdRayTracer::occluded(RayKind /*kind*/, const RayWave& rays, std::vector<std::uint8_t>& occluded) const {
    occluded.resize(rays.size());
    traceAny(scene_, spanOf(rays), threadMemory().streams, occluded.data());
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
    return tracer;
}

void KdRayTracer::findObstacles(const RayWave& rays, std::span<const std::uint8_t> clear,
                                std::vector<Obstacle>& found) const {
    static_assert(static_cast<int>(Obstacle::None) == 0 && static_cast<int>(Obstacle::Opaque) == 1 &&
                  static_cast<int>(Obstacle::Unknown) == 2);
    found.resize(rays.size());
    KernelScene scene = scene_;
    scene.clear = clear.data();
    traceAny(scene, spanOf(rays), threadMemory().streams, reinterpret_cast<std::uint8_t*>(found.data()));
}

} // namespace rtcore

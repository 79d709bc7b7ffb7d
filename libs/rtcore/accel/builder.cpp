#include "rtcore/accel/builder.h"

#include "rtcore/accel/event_sort.h"
#include "rtcore/accel/exact_builder.h"
#include "rtcore/accel/fast_builder.h"
#include "rtcore/accel/mesh_bounds.h"
#include "rtcore/accel/quick_builder.h"
#include "rtcore/accel/triangle_clip.h"
#include "rtcore/platform/task_errors.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <stdexcept>
#include <utility>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace rtcore {

namespace {

class Stopwatch {
  public:
    /// Seconds since the last call or the construction.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Deep enough for any tree worth having (Havran 2000), and never deeper than traversal stacks.
int depthLimit(std::size_t triangles) {
    const int log2 = static_cast<int>(std::bit_width(triangles));
    return std::min(kMaxKdDepth - 1, 10 + log2 + log2 / 2);
}

KdTree emptyTree(const BuildOptions& options) {
    Subtree leaf;
    leaf.nodes.emplace_back();
    return stitch(leaf, options.bounds.value_or(Box3{}));
}

/// Inside a parallel region, by one thread.
KdTree build(BuildContext& context, const BuildOptions& options, BuildTimes& times) {
    Stopwatch watch;
    const Box3 bounds = options.bounds ? *options.bounds : boundsInTasks(context.mesh);
    context.margin = clipMargin(bounds);
    std::unique_ptr<Subtree> root;
    if (options.method == BuildMethod::Fast) {
        times.prepare = watch.lap();
        root = options.fastQuality <= kQuickQuality
                   ? buildQuick(context, bounds)
                   : buildFast(context, fastOptions(options.fastQuality), bounds);
    } else {
        EventLists lists{makeEvents(context.mesh, bounds),
                         static_cast<std::uint32_t>(context.mesh.triangles.size())};
        times.prepare = watch.lap();
        root = buildExact(context, std::move(lists), bounds);
    }
    times.split = watch.lap();
    KdTree tree = stitch(*root, bounds);
    root.reset();
    times.emit = watch.lap();
    return tree;
}

} // namespace

float automaticIntersectionCost(std::size_t triangles) {
    if (triangles < 100'000) return 0.3F;
    if (triangles < 500'000) return 0.2F;
    return triangles < 4'000'000 ? 0.15F : 0.12F;
}

KdTree buildKdTree(const Mesh& mesh, const BuildOptions& options, BuildTimes* times,
                   BuildProgress* progress) {
    const std::size_t triangles = mesh.triangles.size();
    if (triangles == 0) return emptyTree(options);
    if (triangles > kEventTriangleMask)
        throw std::length_error("a scene may have at most 2^30 - 1 triangles");

    BuildTimes ownTimes;
    BuildTimes& t = times != nullptr ? *times : ownTimes;
    BuildContext context{mesh, {}, depthLimit(triangles), std::max(0, options.lookAhead), 0, progress};
    context.cost.traversal = options.traversalCost;
    context.cost.intersection =
        options.intersectionCost > 0 ? options.intersectionCost : automaticIntersectionCost(triangles);
    context.cost.emptyFactor = 1 - options.emptyBonus;
    if (progress != nullptr) progress->triangles = triangles;

    TaskErrors errors;
    KdTree tree;
#ifdef _OPENMP
#pragma omp parallel num_threads(options.threads > 0 ? options.threads                                       \
                                                     : omp_get_max_threads()) default(shared)
#pragma omp single
#endif
    errors.guard([&] { tree = build(context, options, t); });
    errors.rethrow();
    return tree;
}

} // namespace rtcore

#include "rtserver/frames/tree_refinement.h"

#include "common/process/threads.h"

#include "rtcore/accel/tree_within.h"
#include "rtcore/accel/visible_tree.h"

#include <chrono>
#include <cstdint>
#include <utility>

namespace rtserver {

namespace {

rtcore::KdTree treeOf(const rtcore::Model& model, const TreeRefinement::Part& part,
                      const rtcore::Box3& bounds, const rtcore::BuildOptions& options,
                      rtcore::BuildProgress& progress) {
    const bool all = part.hidden == nullptr;
    if (all && part.halves.empty()) return buildKdTree(model.mesh, options, nullptr, &progress);
    const std::vector<std::uint8_t> hidden =
        all ? std::vector<std::uint8_t>() : partTriangles(model, part.hidden);
    return part.halves.empty() ? buildVisibleTree(model.mesh, hidden, bounds, options, &progress)
                               : buildTreeWithin(model.mesh, hidden, part.halves, bounds, options, &progress);
}

} // namespace

TreeRefinement::TreeRefinement(const rtcore::Scene& scene, Part part, const rtcore::Box3& bounds, int threads)
    : result_(std::async(std::launch::async,
                         [this, model = scene.model, part = std::move(part), bounds, threads] {
                             using Clock = std::chrono::steady_clock;
                             const Clock::time_point begun = Clock::now();
                             app::useThreads(threads);
                             rtcore::BuildOptions options;
                             options.threads = threads;
                             Result result;
                             result.tree = treeOf(model, part, bounds, options, progress_);
                             result.tracer = std::make_shared<const rtcore::KdRayTracer>(
                                 result.tree, model.mesh, chooseLeafRecords(result.tree, 0));
                             result.part = part;
                             result.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
                             return result;
                         })) {}

TreeRefinement::~TreeRefinement() {
    giveUp();
    if (result_.valid()) result_.wait();
}

bool TreeRefinement::done() const {
    return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

} // namespace rtserver

#include "rtserver/frames/tree_refinement.h"

#include "common/process/threads.h"

#include "rtcore/accel/visible_tree.h"

#include <chrono>

namespace rtserver {

TreeRefinement::TreeRefinement(const rtcore::Scene& scene, const rtcore::HiddenParts& hidden,
                               const rtcore::Box3& bounds, int threads)
    : result_(std::async(std::launch::async, [this, model = scene.model, hidden, bounds, threads] {
          using Clock = std::chrono::steady_clock;
          const Clock::time_point begun = Clock::now();
          app::useThreads(threads);
          rtcore::BuildOptions options;
          options.threads = threads;
          Result result;
          result.tree = hidden == nullptr ? buildKdTree(model.mesh, options, nullptr, &progress_)
                                          : buildVisibleTree(model.mesh, partTriangles(model, hidden), bounds,
                                                             options, &progress_);
          result.tracer = std::make_shared<const rtcore::KdRayTracer>(result.tree, model.mesh,
                                                                      chooseLeafRecords(result.tree, 0));
          result.hidden = hidden;
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

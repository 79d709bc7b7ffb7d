#include "rtserver/tree_refinement.h"

#include "common/process/threads.h"

#include <chrono>

namespace rtserver {

TreeRefinement::TreeRefinement(const rtcore::Model& model, int threads)
    : result_(std::async(std::launch::async, [this, model, threads] {
          using Clock = std::chrono::steady_clock;
          const Clock::time_point begun = Clock::now();
          app::useThreads(threads);
          rtcore::BuildOptions options;
          options.threads = threads;
          Result result;
          result.tree = buildKdTree(model.mesh, options, nullptr, &progress_);
          result.tracer = std::make_shared<const rtcore::KdRayTracer>(result.tree, model.mesh,
                                                                      chooseLeafRecords(result.tree, 0));
          result.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
          return result;
      })) {}

TreeRefinement::~TreeRefinement() {
    progress_.cancel = true;
    if (result_.valid()) result_.wait();
}

bool TreeRefinement::done() const {
    return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

} // namespace rtserver

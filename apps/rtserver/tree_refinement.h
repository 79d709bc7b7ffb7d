/// The exact kd-tree of a scene that is shown from a fast one meanwhile.
#pragma once

#include "rtcore/accel/builder.h"
#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/model.h"

#include <future>
#include <memory>

namespace rtserver {

/// A thread of its own builds; all functions are for the one thread that has the object. The destructor gives
/// the work up.
class TreeRefinement {
  public:
    TreeRefinement(const rtcore::Model& model, int threads);
    ~TreeRefinement();
    TreeRefinement(const TreeRefinement&) = delete;
    TreeRefinement& operator=(const TreeRefinement&) = delete;

    bool done() const;

    struct Result {
        rtcore::KdTree tree;
        std::shared_ptr<const rtcore::KdRayTracer> tracer; ///< of that tree
        double seconds = 0;
    };
    /// Once, when done(). Throws std::bad_alloc: the fast tree has to do then.
    Result take() { return result_.get(); }

  private:
    rtcore::BuildProgress progress_;
    std::future<Result> result_; ///< last: its thread uses the others
};

} // namespace rtserver

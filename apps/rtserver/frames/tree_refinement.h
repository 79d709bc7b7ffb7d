/// A better kd-tree of a scene that is shown by another one meanwhile.
#pragma once

#include "rtcore/accel/builder.h"
#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/math/half_space.h"
#include "rtcore/scene/scene.h"

#include <future>
#include <memory>
#include <vector>

namespace rtserver {

/// A thread of its own builds; all functions are for the one thread that has the object. The destructor gives
/// the work up, and waits until its thread has noticed.
class TreeRefinement {
  public:
    /// A part of the scene's model.
    struct Part {
        rtcore::HiddenParts hidden;            ///< lacks these
        std::vector<rtcore::HalfSpace> halves; ///< and what is not partly within all of them
    };
    /// The exact tree of a part, with the bounds of all that is there.
    TreeRefinement(const rtcore::Scene& scene, Part part, const rtcore::Box3& bounds, int threads);
    ~TreeRefinement();
    TreeRefinement(const TreeRefinement&) = delete;
    TreeRefinement& operator=(const TreeRefinement&) = delete;

    /// Its result will not be taken: the thread ends soon.
    void giveUp() { progress_.cancel = true; }
    bool done() const;

    struct Result {
        rtcore::KdTree tree;
        std::shared_ptr<const rtcore::KdRayTracer> tracer; ///< of that tree
        Part part;
        double seconds = 0;
    };
    /// Once, when done(). Throws std::bad_alloc: the other tree has to do then.
    Result take() { return result_.get(); }

  private:
    rtcore::BuildProgress progress_;
    std::future<Result> result_; ///< last: its thread uses the others
};

} // namespace rtserver

/// Parts that sections leave whole, where they stand before caps.
#pragma once

#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/image.h"
#include "rtcore/scene/scene.h"

namespace rtcore {

/// Immutable; safe from many threads. The model must outlive it.
class UncutCover {
  public:
    /// Builds a tree of the uncut parts that are not hidden.
    explicit UncutCover(const Scene& scene);

    /// Puts back what they hide of caps, to a pixel: `before` is the image without caps. All threads.
    void restore(const Scene& scene, const Camera& camera, const LdrImage& before, LdrImage& image) const;

  private:
    KdTree tree_;
    KdRayTracer tracer_;
};

} // namespace rtcore

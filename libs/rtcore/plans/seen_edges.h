/// Edges of a model that are seen straight along a plane's normal.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/plans/flat_region.h"
#include "rtcore/scene/scene.h"
#include "rtcore/sections/section_caps.h"

#include <atomic>
#include <vector>

namespace rtcore {

/// Edges below the plane, as lines in it: where a surface ends, bends by more than 20 degrees, or turns away
/// from who looks down on it, as far as no other surface is above them and `solids`, which the plane cuts,
/// are not. They are looked at in steps of `step` scene units, and where what is seen changes to a 64th of
/// that. What is transparent hides as walls do. Lines that lie on each other are one.
///
/// `tracer` is of the scene's model without hidden parts. The same for each number of threads. Empty, and of
/// no use, once `cancel` is set.
std::vector<FlatLine> seenEdges(const Scene& scene, const RayTracer& tracer, const CutPlane& plane,
                                const FlatRegion& solids, double step, const std::atomic<bool>& cancel);

} // namespace rtcore

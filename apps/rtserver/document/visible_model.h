/// The visible part of a model, as it is traced.
#pragma once

#include "rtserver/document/world.h"

#include "rtcore/accel/kd_tree.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/math/half_space.h"
#include "rtcore/render/section_tracer.h"
#include "rtcore/scene/scene.h"

#include <memory>
#include <span>
#include <vector>

namespace rtserver {

/// The tree of what is not hidden, and its tracers. Stays where it is: the player refers to its tree. One
/// thread changes it; others may read while it does not.
class VisibleModel {
  public:
    /// At once: the tree of all, pruned where parts are hidden.
    void prune(const World& world, const rtcore::Scene& scene);
    /// A tree that was built of the visible parts alone, by which rays are faster than by a pruned one.
    void replace(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer,
                 const rtcore::Scene& scene);
    /// The scene has another ground, or other sections; the surfaces are the same.
    void take(const rtcore::Scene& scene);
    /// A tracer by a tree that was built of what is within `halves` (rtcore::buildTreeWithin()), by which
    /// rays are faster than by a reduced one. Nothing where the sections leave something else by now.
    void useWithin(const rtcore::KdRayTracer& built, std::span<const rtcore::HalfSpace> halves,
                   const rtcore::Scene& scene);

    const rtcore::KdTree& tree() const { return tree_; }
    /// Meets the surfaces alone, whatever sections leave of them; to be kept as tracer() is.
    const std::shared_ptr<const rtcore::KdRayTracer>& surfaces() const { return surfaces_; }
    /// A pruned tree is in use.
    bool pruned() const { return pruned_; }
    /// What sections leave is within these; none: no section cuts the model.
    std::span<const rtcore::HalfSpace> halves() const { return halves_; }
    /// Sections cut the model, and a reduced tree of what they leave is in use.
    bool reduced() const { return !halves_.empty() && !built_; }
    /// Meets the surfaces, as sections leave them, and the ground. A thread of its own that traces keeps it,
    /// together with a scene: that owns the triangles.
    const std::shared_ptr<const rtcore::RayTracer>& tracer() const { return tracer_; }

  private:
    rtcore::KdTree tree_;
    bool pruned_ = false;
    std::shared_ptr<const rtcore::KdRayTracer> surfaces_; ///< by that tree
    rtcore::SectionSurfaces sections_;                    ///< of those
    std::vector<rtcore::HalfSpace> halves_;
    bool built_ = false; ///< the tree of what is within them
    std::shared_ptr<const rtcore::RayTracer> tracer_;
};

} // namespace rtserver

/// The part of a scene, and of rays, that planes leave.
#pragma once

#include "rtcore/kernels/clip_rays.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/box.h"
#include "rtcore/scene/section_planes.h"

#include <span>
#include <vector>

namespace rtcore {

/// How far planes lie further out than they are given, so that faces in them stay: what positions within
/// `bounds` are rounded by.
float roundingOf(const Box3& bounds);

/// Immutable.
class SectionClip {
  public:
    SectionClip() = default;
    /// Planes beyond `bounds`, those of all that may be hit, which they leave whole, cost nothing. Faces in a
    /// plane stay: planes lie further out by what positions are rounded.
    SectionClip(const SectionPlanes& sections, const Box3& bounds);

    /// It clips no ray.
    bool empty() const { return halves_.empty(); }
    /// All that is left is within each of these.
    std::span<const HalfSpace> halves() const { return halves_; }
    /// Whether the point was taken away.
    bool removes(Vec3 point) const;
    /// The interval becomes that part of it that is left; where none is, tMin > tMax.
    void clip(const Ray& ray, float& tMin, float& tMax) const;

  private:
    std::vector<HalfSpace> halves_;
};

} // namespace rtcore

/// The rays of a view, in the order in which a renderer makes them.
#pragma once

#include "bench/rtbench/bench_view.h"
#include "bench/rtbench/ray_test.h"

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/mesh.h"
#include "support/view_rays.h"

#include <cstddef>
#include <vector>

namespace rtbench {

/// Rays of one kind. There are no gaps: every wave but the last is full.
struct RaySet {
    const RayTest* test = nullptr;
    std::vector<rtcore::RayWave> waves;
    std::size_t rays = 0;
};

/// Rays in a full wave: what the renderer's queues take at a time.
inline constexpr std::size_t kWaveRays = 16384;

/// The same rays at every call. Surfaces are found by `tracer`; both it and `mesh` must outlive the object.
class RaySource {
  public:
    /// The rays are those of an image of `size` x `size` pixels.
    RaySource(const rtcore::Mesh& mesh, const rtcore::RayTracer& tracer, const BenchView& view, int size);

    /// Empty where the view shows nothing.
    RaySet make(const RayTest& test) const;

  private:
    std::vector<test::SurfacePoint> surfaces(const std::vector<rtcore::Ray>& primary) const;
    std::vector<rtcore::Ray> occlusionRays() const;
    std::vector<rtcore::Ray> mirrorRays() const;

    const rtcore::Mesh& mesh_;
    const rtcore::RayTracer& tracer_;
    BenchView view_;
    int size_;
    float diagonal_;
    std::vector<rtcore::Ray> primary_;
    std::vector<rtcore::Hit> hits_; ///< of the primary rays
    std::vector<test::SurfacePoint> points_;
};

} // namespace rtbench

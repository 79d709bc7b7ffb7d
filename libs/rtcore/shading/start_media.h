/// The solids of glass that primary rays begin in.
#pragma once

#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/scene/scene.h"
#include "rtcore/shading/paths/path_queue.h"
#include "rtcore/shading/wave.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rtcore {

/// Found by counting what a ray from there in a fixed direction comes into and leaves, where the box of a
/// solid is around. One for each thread; keeps its memory.
class StartMedia {
  public:
    /// For the rays of a wave, the first of which is of the sample `first`.
    void find(const Scene& scene, const RayTracer& tracer, const RayWave& rays, std::uint32_t first);
    /// Whether any of them begins in a solid.
    bool any() const { return any_; }
    Path pathOf(std::size_t ray) const;

  private:
    MediaList around(const RayTracer& tracer, Vec3 point);

    const Scene* scene_ = nullptr;
    std::uint32_t first_ = 0;
    bool any_ = false;
    std::vector<MediaList> media_; ///< by ray
    std::vector<Box3> near_;       ///< of solids
    RayWave ray_;
    HitWave hit_;
};

/// Weights what primary rays hit by what is absorbed on the way, where they begin in solids.
void absorbFromStart(Wave& wave);

} // namespace rtcore

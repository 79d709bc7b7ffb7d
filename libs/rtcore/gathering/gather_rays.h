/// Rays from irradiance records over the hemispheres before them.
#pragma once

#include "rtcore/gathering/connected_surfaces.h"
#include "rtcore/irradiance/outgoing_cells.h"
#include "rtcore/kernels/ray_tracer.h"
#include "rtcore/kernels/ray_wave.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/scene.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

inline constexpr std::size_t kPassRays = 64; ///< of a record at once

/// One pass of a record.
struct GatherPass {
    std::uint32_t record;
    Vec3 origin;          ///< just off the surface
    Vec3 normal;          ///< unit, of the face
    std::uint32_t name;   ///< of the record's random numbers
    std::uint32_t number; ///< of the pass, from 0 on
};

/// Appends the rays of a pass, with the density cos / pi: one in each of 8 x 8 strata of equal weight, and
/// all passes of a record together are as even (Owen's sequence). Neighbours follow each other.
void addGatherRays(const GatherPass& pass, RayWave& rays);

/// Where rays go.
struct GatherScene {
    const Scene& scene;
    const RayTracer& tracer;
    const ConnectedSurfaces& surfaces;
    const OutgoingCells& cells; ///< that they read
};

/// Where a ray ends that hit something there.
OutgoingCells::Site siteOf(const GatherScene& in, const Ray& ray, const Hit& hit);

/// Where rays of passes end.
class GatherHits {
  public:
    /// Traces the rays of passes, in several threads: those of passes[i] are from i * kPassRays on. The same
    /// for any number of them. Returns false when `stop` (may be null) became true: some were left then.
    bool trace(const GatherScene& in, std::span<const GatherPass> passes, int threads,
               const std::atomic<bool>* stop = nullptr);

    std::size_t size() const { return sites_.size(); }
    bool isHit(std::size_t ray) const { return sites_[ray].level != OutgoingCells::kNowhere; }
    /// Nowhere, with a length of 1e15, where nothing is hit, and no longer than that.
    const OutgoingCells::Site& site(std::size_t ray) const { return sites_[ray]; }
    std::span<const OutgoingCells::Site> sites() const { return sites_; }
    Vec3 direction(std::size_t ray) const { return directions_[ray]; }
    Ray ray(std::size_t ray, std::span<const GatherPass> passes) const;

  private:
    std::vector<OutgoingCells::Site> sites_;
    std::vector<Vec3> directions_;
};

} // namespace rtcore

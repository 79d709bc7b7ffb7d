/// Paths that find the radiance of cells: some of the rays of records go on as paths.
#pragma once

#include "rtcore/gathering/gather_rays.h"
#include "rtcore/irradiance/outgoing_cells.h"
#include "rtcore/math/colour.h"
#include "rtcore/pathtracing/path_integrator.h"
#include "rtcore/sampling/sample_id.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

/// Rays that may go on as paths, by where they end.
struct RaysToCells {
    /// A ray, and the name of its path's random numbers.
    struct Named {
        Ray ray;
        SampleId name;
    };
    std::span<const OutgoingCells::Site> sites;
    std::function<Named(std::size_t)> ray; ///< that of sites[i]; from many threads
};

/// Keeps its memory, some MB for each thread.
class CellPaths {
  public:
    /// Traces about `budget` of the rays as paths, those first whose cells know least, and adds what they
    /// find to the cells. `frame` differs from call to call. The same bits for any number of threads. Returns
    /// false, with the cells as they were, when `stop` (may be null) became true.
    bool fill(const PathFrame& paths, const GatherHits& hits, std::span<const GatherPass> passes,
              std::size_t budget, std::uint32_t frame, int threads, const std::atomic<bool>* stop,
              OutgoingCells& cells);
    bool fill(const PathFrame& paths, const RaysToCells& rays, std::size_t budget, std::uint32_t frame,
              int threads, const std::atomic<bool>* stop, OutgoingCells& cells);
    /// The same of every `step`-th ray of each pass, whatever cells know.
    bool fillEvenly(const PathFrame& paths, const GatherHits& hits, std::span<const GatherPass> passes,
                    std::size_t step, std::uint32_t frame, int threads, const std::atomic<bool>* stop,
                    OutgoingCells& cells);

    /// The rays that went on last, and the radiance that came along them.
    std::span<const std::uint32_t> chosen() const { return chosen_; }
    std::span<const Colour> radiance() const { return radiance_; }

  private:
    void addTo(OutgoingCells& cells, std::span<const OutgoingCells::Site> sites, std::uint32_t frame) const;
    void choose(std::span<const OutgoingCells::Site> sites, const OutgoingCells& cells, std::size_t budget,
                std::uint32_t frame, int threads);
    bool trace(const PathFrame& paths, const RaysToCells& rays, int threads, const std::atomic<bool>* stop);

    std::vector<std::unique_ptr<PathIntegrator>> integrators_; ///< by thread
    std::vector<std::uint8_t> knowledge_; ///< by ray: how many digits the number of its cell's samples has
    std::vector<std::uint32_t> chosen_;   ///< rays
    std::vector<Colour> radiance_;        ///< the same
};

} // namespace rtcore

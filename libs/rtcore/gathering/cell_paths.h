/// Paths that find the radiance of cells: some of the rays of records go on as paths.
#pragma once

#include "rtcore/gathering/gather_rays.h"
#include "rtcore/irradiance/outgoing_cells.h"
#include "rtcore/math/colour.h"
#include "rtcore/pathtracing/path_integrator.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace rtcore {

/// Keeps its memory, some MB for each thread.
class CellPaths {
  public:
    /// Traces about `budget` of the rays as paths, those first whose cells know least, and adds what they
    /// find to the cells. `frame` differs from call to call. The same bits for any number of threads. Returns
    /// false, with the cells as they were, when `stop` (may be null) became true.
    bool fill(const PathFrame& paths, const GatherHits& hits, std::span<const GatherPass> passes,
              std::size_t budget, std::uint32_t frame, int threads, const std::atomic<bool>* stop,
              OutgoingCells& cells);
    /// The same of every `step`-th ray of each pass, whatever cells know.
    bool fillEvenly(const PathFrame& paths, const GatherHits& hits, std::span<const GatherPass> passes,
                    std::size_t step, std::uint32_t frame, int threads, const std::atomic<bool>* stop,
                    OutgoingCells& cells);

    /// The rays that went on last, and the radiance that came along them.
    std::span<const std::uint32_t> chosen() const { return chosen_; }
    std::span<const Colour> radiance() const { return radiance_; }

  private:
    void addTo(OutgoingCells& cells, const GatherHits& hits, std::uint32_t frame) const;
    void choose(const GatherHits& hits, const OutgoingCells& cells, std::size_t budget, std::uint32_t frame,
                int threads);
    bool trace(const PathFrame& paths, const GatherHits& hits, std::span<const GatherPass> passes,
               int threads, const std::atomic<bool>* stop);

    std::vector<std::unique_ptr<PathIntegrator>> integrators_; ///< by thread
    std::vector<std::uint8_t> knowledge_; ///< by ray: how many digits the number of its cell's samples has
    std::vector<std::uint32_t> chosen_;   ///< rays
    std::vector<Colour> radiance_;        ///< the same
};

} // namespace rtcore

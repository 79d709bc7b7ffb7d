/// Finds what passes of records learn: their rays read cells, which some of them, that go on as paths, fill.
#pragma once

#include "rtcore/gathering/cell_paths.h"
#include "rtcore/gathering/connected_surfaces.h"
#include "rtcore/gathering/emitter_rays.h"
#include "rtcore/gathering/gather_rays.h"
#include "rtcore/gathering/lit_scene.h"
#include "rtcore/gathering/record_passes.h"
#include "rtcore/irradiance/outgoing_cells.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rtcore {

/// What is gathered of, and how.
struct GatherTask {
    const LitScene& lit;
    const ConnectedSurfaces& surfaces;
    std::uint32_t frame; ///< of the cells; differs from call to call
    int threads;
    const std::atomic<bool>* stop = nullptr; ///< may be null
};

/// Keeps its memory. The same bits for any number of threads.
class PassGatherer {
  public:
    /// About `paths` rays go on as paths, those first whose cells know least. Returns false when `stop`
    /// became true: the cells are as they were then, and there are no results.
    bool gather(const GatherTask& task, std::span<const GatherPass> passes, std::size_t paths,
                OutgoingCells& cells);
    /// Every `step`-th ray of each pass goes on as a path, whatever is known: the same ones in each scene.
    /// There are no results yet.
    bool gatherEvenly(const GatherTask& task, std::span<const GatherPass> passes, std::size_t step,
                      OutgoingCells& cells);
    /// The results of passes whose rays were traced, by what cells know now.
    void sumUp(const GatherTask& task, std::span<const GatherPass> passes, GatherHits&& hits,
               const OutgoingCells& cells);

    std::span<const PassResult> results() const { return results_; } ///< by pass
    const GatherHits& hits() const { return hits_; }
    const CellPaths& paths() const { return cellPaths_; }

  private:
    bool trace(const GatherTask& task, std::span<const GatherPass> passes, const OutgoingCells& cells);
    void sumUp(const GatherTask& task, std::span<const GatherPass> passes, const OutgoingCells& cells);
    PassResult resultOf(const LitScene& lit, std::span<const GatherPass> passes, std::size_t pass,
                        const OutgoingCells& cells) const;

    GatherHits hits_;
    CellPaths cellPaths_;
    EmitterRays emitterRays_;
    std::vector<PassLight> emitted_; ///< by pass
    std::vector<PassResult> results_;
};

} // namespace rtcore

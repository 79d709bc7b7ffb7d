/// An edit that hides or shows parts of a model, while it is found out how much light it changes.
#pragma once

#include "rtcore/gathering/light_difference.h"
#include "rtcore/gathering/lit_scene.h"
#include "rtcore/gathering/pass_gatherer.h"
#include "rtcore/irradiance/irradiance_cache.h"
#include "rtcore/irradiance/outgoing_cells.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

/// Some records pass once in each state, a part of them after the other. It can be stopped at any time, and
/// goes on as if it had not been.
class PartsChange {
  public:
    /// Of the state whose light is known, with the cells that tell of it.
    PartsChange(LitScene&& before, OutgoingCells&& cells)
        : before_(std::move(before)), cells_(std::move(cells)) {}

    /// Compares it with another state, from the beginning, by these passes of all records, of which there are
    /// so many. `frame`: of all cells that come of it.
    void begin(std::span<const GatherPass> passes, std::size_t records, const Box3& bounds,
               std::uint32_t frame);
    /// So many records, or some more, pass in the step of this number. `now` is of the other state and of
    /// frame(), and `cells` of what was found there since begin(). Returns false when that was stopped.
    bool compare(const GatherTask& now, std::uint32_t step, std::size_t records, PassGatherer& gatherer,
                 OutgoingCells& cells);
    std::uint32_t frame() const { return frame_; }
    /// All have passed, and there was more to do in this step.
    bool compared() const { return left_ > 0 && passed_ == passes_.size(); }
    /// Once, after that.
    const LightDifference& difference(const GatherTask& now, const IrradianceCache& cache,
                                      PassGatherer& gatherer, const OutgoingCells& cells) {
        difference_.finish(taskBefore(now), now, cache, gatherer, cells);
        return difference_;
    }

    LitScene& before() { return before_; }
    OutgoingCells& cells() { return cells_; }
    std::size_t records() const { return records_; } ///< those with higher numbers were made since
    std::span<const GatherPass> passes() const { return passes_; }
    std::span<const OutgoingCells::Site> sites() const { return sites_; } ///< where rays met the other state
    /// What was found was taken, but for further passes of what it made unknown.
    void take() { taken_ = true; }
    bool taken() const { return taken_; }

  private:
    GatherTask taskBefore(const GatherTask& now) const {
        return {before_, now.surfaces, now.frame, now.threads, now.stop};
    }

    LitScene before_;
    OutgoingCells cells_;
    LightDifference difference_;
    std::vector<GatherPass> passes_;
    std::vector<OutgoingCells::Site> sites_;
    std::size_t records_ = 0;
    std::size_t passed_ = 0;    ///< in both states
    bool passedBefore_ = false; ///< the part after those in the first one
    std::size_t left_ = 0;      ///< of the step
    std::uint32_t step_ = 0, frame_ = 0;
    bool taken_ = false;
};

} // namespace rtcore

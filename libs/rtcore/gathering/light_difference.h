/// By how much the light of records differs between two states of a scene.
#pragma once

#include "rtcore/gathering/gather_rays.h"
#include "rtcore/gathering/pass_gatherer.h"
#include "rtcore/irradiance/irradiance_cache.h"
#include "rtcore/irradiance/irradiance_record.h"
#include "rtcore/irradiance/outgoing_cells.h"
#include "rtcore/math/box.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rtcore {

/// Found by rays and paths with the same random numbers in both states, so that it is nothing, not noise,
/// where none of them meets anything else. At most a difference is 1, at least 0.
class LightDifference {
  public:
    /// Forgets all; cells lie in these bounds.
    void begin(const Box3& bounds);
    /// Some records pass in the state before. Returns false when that was stopped: then all is as it was.
    bool passBefore(const GatherTask& task, std::span<const GatherPass> passes, PassGatherer& gatherer);
    /// The same ones pass in the state now. What paths find there goes to `cells`, which know what paths of
    /// this comparison found, and nothing else.
    bool passNow(const GatherTask& task, std::span<const GatherPass> passes, PassGatherer& gatherer,
                 OutgoingCells& cells);
    /// Once all have passed, of the cache. The tasks are those of the passes.
    void finish(const GatherTask& before, const GatherTask& now, const IrradianceCache& cache,
                PassGatherer& gatherer, const OutgoingCells& cells);
    /// Of what arrives at a record, by those that passed around it.
    struct Arriving {
        float difference = 1;
        Colour ratio; ///< by channel: how much of the light there is now, where the difference is small
    };
    Arriving arrivingAt(const IrradianceRecord& record) const;
    /// Of what leaves a surface where a ray of `now` ends.
    float leaving(const OutgoingCells::Site& site) const;

  private:
    /// A record that passed, and what arrived there: by cells that its rays read, and along paths, which do
    /// not read any.
    struct Passed {
        IrradianceRecord record;
        Colour before, now, pathsBefore, pathsNow;
        float difference = 0;
        float around = 1; ///< the same by some around it
    };
    /// Of some of them.
    struct Sum {
        float difference = 0, count = 0;
        Colour known, before, now, pathsBefore, pathsNow;
        void add(const Passed& passed);
        bool tellsEnough() const;
        float mean() const;
    };
    /// Where rays of passes ended, and what came along paths, by pass.
    struct Rays {
        GatherHits hits;
        std::vector<Colour> byPaths;
    };
    /// Passes of the same time, in both states.
    struct Part {
        std::vector<GatherPass> passes;
        Rays before, now;
    };
    static bool gather(const GatherTask& task, std::span<const GatherPass> passes, PassGatherer& gatherer,
                       OutgoingCells& cells, Rays& found);
    void order(std::size_t first, std::size_t last, int axis);
    template <typename Suits>
    void findNearest(Vec3 point, std::size_t first, std::size_t last, int axis, const Suits& suits,
                     std::vector<std::pair<float, std::uint32_t>>& nearest, std::size_t wanted) const;
    template <typename Suits, typename Use>
    void forNearest(Vec3 point, std::size_t wanted, const Suits& suits, Use&& use) const;
    float differenceAround(const IrradianceRecord& record) const;
    template <typename Suits>
    float meanOfNearest(Vec3 point, const Suits& suits) const;

    std::vector<Passed> passed_; ///< a tree: the middle one of a range splits it, along x, y and z in turns
    std::vector<Part> parts_;    ///< until all have passed
    Rays were_;                  ///< of those that have passed in the state before alone
    OutgoingCells before_, now_; ///< of the paths
};

} // namespace rtcore

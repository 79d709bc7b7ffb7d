/// The light that surfaces send to each other, and the light of the surroundings, at the points that are
/// seen: learned from frame to frame, and remembered. Irradiance records are what is shown; their rays read
/// cells of outgoing radiance, which paths of the path tracer fill, so that both show the same light.
/// (docs/live.md, "Indirect light")
#pragma once

#include "rtcore/gathering/connected_surfaces.h"
#include "rtcore/gathering/curve_order.h"
#include "rtcore/gathering/fresh_records.h"
#include "rtcore/gathering/gather_rays.h"
#include "rtcore/gathering/indirect_state.h"
#include "rtcore/gathering/lit_scene.h"
#include "rtcore/gathering/lobe_rays.h"
#include "rtcore/gathering/parts_change.h"
#include "rtcore/gathering/pass_gatherer.h"
#include "rtcore/gathering/record_passes.h"
#include "rtcore/irradiance/irradiance_cache.h"
#include "rtcore/irradiance/outgoing_cells.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace rtcore {

class ChangedSurfaces;
class LightDifference;

/// The work of a step.
struct GatherBudget {
    std::uint32_t rays = 16384; ///< from records, by 64
    std::uint32_t paths = 1536; ///< of them that go on as paths, about
    /// Records with so many passes get no more; coarse ones with a quarter of them.
    std::uint32_t enough = std::numeric_limits<std::uint32_t>::max();
    /// Times as many rays and paths where nothing is known of what is seen, as far as that is all of it; 1 at
    /// least.
    double maxTimes = kMaxTimes;
    static constexpr double kMaxTimes = 4;
    /// After an edit of parts so many of some 1,000 records are compared in a step, each by 128 rays and 32
    /// paths, before others learn.
    std::uint32_t compared = std::numeric_limits<std::uint32_t>::max();

    /// Of lobes, in addition.
    std::uint32_t lobePaths() const { return paths / 4; }
};

/// What a thread needs to look up lobes; keeps its memory.
struct LobeScratch {
    LobeRays rays;
    std::vector<OutgoingCells::Site> sites;
};

/// Not for several threads at once: it uses all of them itself. Its state depends on the scene and the steps
/// since begin() alone, to the bit, for any number of threads and instruction set. Throws std::bad_alloc.
class IndirectLight {
  public:
    /// Forgets all, and takes the light of this scene. The arguments must live until the next call; of the
    /// settings count `path`, textures, shadows, reflections, refractions, maxDepth, fog.
    void begin(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings);
    /// Takes a scene in which lights, materials or surroundings differ, but no surface: positions and radii
    /// of records stay, and each tells nothing until its next pass; coarse ones have theirs first.
    void changeLight(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings);
    /// Takes a scene in which other parts of the same model are hidden, and nothing else differs. Records
    /// near what is hidden or shown go at once. The next steps find out by how much the light of others
    /// differs, and so much they forget then: where it is the same they are as they were. Until then they
    /// show what they did, new ones are made, and the state before must live.
    void changeParts(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings,
                     int threads);
    bool changing() const { return change_.has_value(); } ///< the last changeParts() is not yet followed
    /// The scene before, which must live; null when it is not changing().
    const Scene* sceneBefore() { return change_ ? &change_->before().scene() : nullptr; }

    /// All that was learned since begin(), between two steps, while it is not changing(); as much memory as
    /// memory() tells, or less.
    IndirectState state() const;
    /// Goes on where the light was that the state is of: its surfaces and all that lights them are those of
    /// the last begin(), and checkIndirectState() has nothing against it. Then all to come has the same bits.
    void restore(const IndirectState& kept);
    /// Takes another tracer of the same surfaces.
    void rebind(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings);

    /// Learns, first of all about the receivers, and looks up the light of each. Returns false when `stop`
    /// (may be null) became true: then all is as before, but for which records were of use lately, and what
    /// was compared after an edit, with which the next step goes on.
    bool step(std::span<const Receiver> receivers, std::span<ArrivingLight> arriving,
              const GatherBudget& budget, int threads, const std::atomic<bool>* stop = nullptr);
    /// Looks up the radiance that comes along lobes; and learns of it, by about `paths` paths, after a step
    /// about the same points.
    void learnLobes(std::span<const LobeTap> lobes, std::span<Colour> radiance, std::uint32_t paths,
                    int threads);
    /// The same of what is known. From many threads, while none learns.
    void lookUp(std::span<const LobeTap> lobes, std::span<Colour> radiance, LobeScratch& scratch) const;

    /// Learning in the last step: rays from records, the seconds that all of it took, the fewest passes of a
    /// record that was of use lately and had one, where those of coarse ones count four times, the part of
    /// the receivers that nothing was known of before, or not much, and the standard error of records that
    /// had a pass, on average, as a part of their irradiance. Before it, the seconds that the last
    /// changeParts() took of the step.
    struct Learned {
        std::size_t rays = 0;
        double seconds = 0;
        std::uint32_t minPasses = 0;
        double unknown = 0;
        double secondsOfEdits = 0;
        double error = 0;
    };
    const Learned& learned() const { return learned_; }
    /// Looks up what is known. From many threads, while none learns.
    const IrradianceCache& cache() const { return cache_; }
    const OutgoingCells& cells() const { return cells_; }
    std::uint32_t steps() const { return frame_; } ///< since begin(), or of all that was restored

    std::size_t memory() const; ///< bytes that grow with what is remembered
    /// So many records and cells are remembered; beyond, those that were of no use for longest are forgotten.
    static constexpr std::size_t kMaxRecords = 200'000, kMaxCells = 750'000;
    /// For tests.
    void boundRecords(std::size_t max) { maxRecords_ = max; }

  private:
    /// Records that were of no use for so many steps get no rays.
    static constexpr std::uint32_t kRecentSteps = 24;

    GatherScene gatherScene() const { return {lit_.scene(), lit_.tracer(), surfaces_, cells_}; }
    void addFromCells(std::span<const OutgoingCells::Site> sites, std::span<Colour> radiance) const;
    void lookUp(std::span<const std::uint32_t> numbers, std::span<const Receiver> receivers,
                std::span<ArrivingLight> arriving, std::uint32_t frame, int threads) const;
    bool learn(std::span<const Receiver> receivers, std::span<const ArrivingLight> arriving,
               const GatherBudget& budget, int threads, const std::atomic<bool>* stop);
    void forget(std::uint32_t number);
    void forgetValues();
    void forgetNear(const ChangedSurfaces& changed, int threads);
    void prepareCompared(const Scene& scene, const RayTracer& tracer, const RenderSettings& settings);
    void chooseCompared();
    void chooseEvenly(std::size_t max);
    bool follow(std::size_t compared, int threads, const std::atomic<bool>* stop);
    bool gatherForgotten(int threads, const std::atomic<bool>* stop);
    void takeCells(const LightDifference& difference, int threads);
    void takeDifference(const LightDifference& difference, int threads);
    void forgetUnused();
    void undo(std::size_t records);
    void findLacking(std::span<const Receiver> receivers, std::span<const ArrivingLight> arriving);
    static GatherBudget budgetFor(const GatherBudget& budget, double unknown);
    bool makeRecords(std::span<const Receiver> receivers, std::span<const ArrivingLight> arriving,
                     std::size_t max, const std::atomic<bool>* stop);
    std::uint64_t turnOf(std::uint32_t number) const;
    std::uint32_t pathsFor(std::uint32_t paths) const;
    void chooseRecords(std::size_t max, std::uint32_t enough);
    std::uint32_t countedPasses(std::uint32_t number) const {
        return records_.passes(number) * (records_.density(number) > 0 ? 4U : 1U);
    }
    std::uint32_t minPasses() const;
    void orderChosen();
    void enterResults();
    double meanError() const;
    bool gather(std::size_t paths, std::uint32_t frame, int threads, const std::atomic<bool>* stop);

    LitScene lit_;
    ConnectedSurfaces surfaces_;
    IrradianceCache cache_;
    OutgoingCells cells_;
    RecordPasses records_;
    std::uint32_t frame_ = 0;
    std::size_t maxRecords_ = kMaxRecords;
    bool guesses_ = false; ///< the cache's guess is of this light
    std::optional<PartsChange> change_;
    Learned learned_;

    CurveOrder curve_;
    std::vector<std::uint32_t> lacking_; ///< receivers that coarse records are missing for, too
    std::vector<ArrivingLight> latest_;  ///< by receiver: what was looked up last, while records are made
    std::vector<std::uint32_t> asOf_;    ///< the same: the size of the cache then
    FreshRecords fresh_;
    std::vector<std::uint32_t> chosen_; ///< records that get a pass
    std::vector<GatherPass> passes_;    ///< theirs
    PassGatherer gatherer_;
    std::vector<OutgoingCells::Site> lobeSites_; ///< scratch
    CellPaths lobePaths_;
    std::vector<std::uint64_t> order_; ///< scratch
};

} // namespace rtcore

/// Work beside the frames for the scene that is shown: loading another one, building the exact tree of a
/// large one, the tree of its visible parts and that of what sections leave, making its shadow maps.
#pragma once

#include "rtserver/document/document.h"
#include "rtserver/failure.h"
#include "rtserver/frames/scene_load.h"
#include "rtserver/frames/shadow_mapping.h"
#include "rtserver/frames/tree_refinement.h"
#include "rtserver/messages.h"
#include "rtserver/server_options.h"

#include "rtcore/scene/revisions.h"
#include "rtcore/scene/scene.h"
#include "rtcore/shading/light/shadow_maps.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace rtserver {

/// One thread, which never waits for the work: threads of its own do that.
class SceneUpkeep {
  public:
    /// All must outlive it.
    SceneUpkeep(const Options& options, Document& document, Messages& messages)
        : options_(options), document_(document), messages_(messages) {}

    /// Begins to load another scene. Throws std::runtime_error when one is being loaded. `cachedModel`: as in
    /// rtcore::LoadOptions.
    void load(const std::filesystem::path& path, std::optional<std::filesystem::path> cachedModel);
    bool loads() const { return load_ != nullptr; }
    /// How much of a scene is loaded, 0..1; 1 when none is being loaded.
    float progress() const { return load_ ? load_->fraction() : 1; }

    /// How a load ended.
    struct Loaded {
        std::optional<Failure> failure; ///< nothing: the scene is shown
    };
    /// Once for each load, when it is over; the state shows the scene then. Throws what went wrong when there
    /// is no other scene to go on with.
    std::optional<Loaded> takeLoaded();

    /// How the frames of the scene come.
    struct Pace {
        bool current = false;  ///< the last one shows the current state, maybe coarsely
        bool complete = false; ///< it shows all of it
        bool idle = false;     ///< nothing else is to be done
        double seconds = 0;    ///< that it took
        double coarsest = 0;   ///< seconds of the coarsest ones; 0 = not known
        double wanted = 0;     ///< seconds that one may take while something moves; 0 = any time
        double now = 0;        ///< seconds by a clock that goes on
    };
    /// Takes over what is done, and begins what helps: better trees, by which frames have the same bits and
    /// come faster, and shadow maps, by which coarse frames are quicker and less exact.
    void advance(const Pace& pace);

    /// Whether anything is under way.
    bool works() const { return load_ || refinement_ || visible_ || within_ || mapping_; }
    /// Those of the scene as it is now; null where there are none. Until the next call of any function.
    const rtcore::ShadowMaps* shadowMaps();

  private:
    void show(std::unique_ptr<World> world);
    void tellModelUnits();
    void tellFillLights();
    void noticeChanges();
    void giveUp(std::unique_ptr<TreeRefinement> refinement);
    void refineTree(const Pace& pace);
    void buildVisible(const Pace& pace);
    void noticeSections(bool otherModel);
    void buildWithin(const Pace& pace);
    void mapShadows(const Pace& pace);

    const Options& options_;
    Document& document_;
    Messages& messages_;
    rtcore::Subscription changes_;
    bool indirect_ = false; ///< indirect light is rendered, and fill lights were told of
    std::unique_ptr<SceneLoad> load_;
    std::unique_ptr<TreeRefinement> refinement_;
    bool treeless_ = false; ///< there was no memory for the exact tree
    std::unique_ptr<TreeRefinement> visible_;
    bool prunedOnly_ = false; ///< nor for that of what is visible
    std::unique_ptr<TreeRefinement> within_;
    std::vector<rtcore::HalfSpace> halves_; ///< which that one, or the next, is within
    std::optional<double> restsSince_; ///< the time from which on they have been the same, once it is known
    bool reducedOnly_ = false;         ///< there was no memory for it
    std::vector<std::unique_ptr<TreeRefinement>> leaving_; ///< given up, their threads not yet at their end
    std::unique_ptr<ShadowMapping> mapping_;
    std::unique_ptr<const rtcore::ShadowMaps> maps_;
    std::shared_ptr<const rtcore::Scene> mapped_; ///< what these two are of
    bool mapless_ = false;                        ///< this scene goes without
};

} // namespace rtserver

#include "renderer/load_phases.h"

#include "renderer/variant_choice.h"

#include "common/settings/guess_text.h"
#include "common/settings/settings_merge.h"

#include "common/process/stop.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/closed_surfaces.h"
#include "rtcore/settings/integrator_traits.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

namespace renderer {

namespace {

using Clock = std::chrono::steady_clock;

const char* phaseName(rtcore::LoadPhase phase) {
    switch (phase) {
    case rtcore::LoadPhase::ReadingScene:
        return "reading the scene";
    case rtcore::LoadPhase::ImportingModel:
        return "importing";
    case rtcore::LoadPhase::BuildingTree:
        return "building the tree";
    case rtcore::LoadPhase::LoadingImages:
        return "loading images";
    case rtcore::LoadPhase::Done:
        break;
    }
    return "";
}

// Follows the loader from phase to phase.
class PhaseWatch {
  public:
    PhaseWatch(app::Progress& progress, bool verbose) : progress_(progress), verbose_(verbose) {}

    rtcore::BuildProgress build;
    std::atomic<bool> stopImport{false};

    void enter(rtcore::LoadPhase phase) {
        leave();
        app::throwIfStopped();
        if (phase == rtcore::LoadPhase::Done) return;
        current_ = phaseName(phase);
        begun_ = Clock::now();
        app::ProgressPhase shown{.name = current_, .fraction = {}};
        if (phase == rtcore::LoadPhase::ImportingModel) shown.cancel = &stopImport;
        if (phase == rtcore::LoadPhase::BuildingTree) {
            shown.cancel = &build.cancel;
            shown.fraction = [this] { return buildFraction(build); };
        }
        progress_.begin(std::move(shown));
    }

  private:
    static double buildFraction(const rtcore::BuildProgress& build) {
        const std::uint64_t all = build.triangles.load();
        return all == 0 ? 0.0 : static_cast<double>(build.finished.load()) / static_cast<double>(all);
    }

    void leave() {
        if (current_.empty()) return;
        progress_.end();
        const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
        if (verbose_) progress_.print(fmt::format("{} took {:.3f} s", current_, seconds));
        current_.clear();
    }

    app::Progress& progress_;
    bool verbose_;
    std::string current_;
    Clock::time_point begun_;
};

/// Glass that light passes unbent, since it bounds no solid.
void tellOpenGlass(const std::vector<rtcore::OpenGlass>& open, app::Progress& progress) {
    constexpr std::size_t kMax = 10;
    for (std::size_t i = 0; i < std::min(open.size(), kMax); ++i) {
        const rtcore::OpenGlass& glass = open[i];
        progress.print(fmt::format(
            "the glass of {} is open (edges that do not join two triangles: {}): light passes it unbent, as "
            "through a thin wall; fill its holes and turn all faces outwards to make it a solid",
            glass.part.empty() ? "a part without a name" : fmt::format("\"{}\"", glass.part),
            glass.openEdges));
    }
    if (open.size() > kMax)
        progress.print(fmt::format("the glass of {} other parts is open, too", open.size() - kMax));
}

} // namespace

std::uint64_t knownRays(const RendererOptions& options) {
    if (options.makeLight || options.plan || options.hasFrames() || options.camera || options.settingsFile ||
        options.scene.extension() == ".scn")
        return 0;
    const rtcore::RenderSettings s = app::mergeSettings({.commandLine = options.settings});
    if (rtcore::traitsOf(s.integrator).samplesAllLight) return 0; // the rays from the camera are the fewest
    return static_cast<std::uint64_t>(s.width) * static_cast<std::uint64_t>(s.height) *
           static_cast<std::uint64_t>(s.antialiasing) * static_cast<std::uint64_t>(s.antialiasing);
}

rtcore::LoadedScene loadWithProgress(const RendererOptions& options, app::Progress& progress) {
    PhaseWatch watch(progress, options.verbose);
    rtcore::LoadOptions load;
    load.build.threads = options.threads;
    load.buildProgress = &watch.build;
    load.import = options.import;
    load.import.stop = &watch.stopImport;
    load.model = options.model;
    load.lighting = options.lighting;
    load.primaryRays = knownRays(options);
    load.onPhase = [&](rtcore::LoadPhase phase) { watch.enter(phase); };
    const auto giveUp = [&] { progress.end(false); };
    try {
        rtcore::LoadedScene loaded = rtcore::loadScene(options.scene, load);
        for (const rtcore::Sentence& warning : loaded.warnings)
            progress.tell(rtcore::say("warning: {0}", warning));
        const rtcore::Sentence guess = app::guessText(loaded.units);
        const bool forPeople =
            options.progress != app::ProgressStyle::None && options.progress != app::ProgressStyle::Json;
        if (!guess.empty() && forPeople)
            progress.print(options.scene.filename().string() + ": " + guess.english());
        rtcore::useGuesses(loaded.scene, loaded.guesses);
        if (!loaded.guesses.empty() && forPeople)
            progress.print(options.scene.filename().string() + ": " +
                           rtcore::guessedText(loaded.guesses).english() +
                           "; a .scn of it has them as they are");
        showVariant(options, loaded);
        app::selectParts(options.selection, loaded.scene);
        app::cutOpen(options.selection.sections, loaded.scene);
        app::selectLights(options.selection, loaded.scene);
        if (options.verbose) tellOpenGlass(loaded.openGlass, progress);
        return loaded;
    } catch (const rtcore::BuildCancelled&) {
        giveUp();
        throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
    } catch (...) {
        giveUp();
        throw;
    }
}

} // namespace renderer

#include "rtserver/frames/scene_upkeep.h"

#include "common/commands/command_lines.h"
#include "common/commands/told_forms.h"
#include "common/settings/guess_text.h"

#include "rtcore/look/fill_lights.h"
#include "rtcore/platform/file_waits.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/render/section_tracer.h"
#include "rtcore/scene/up_axis.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rtserver {

namespace {

std::string shortNumber(double value) { return fmt::format("{:.3g}", value); }

} // namespace

// --- Loading ---

void SceneUpkeep::load(const std::filesystem::path& path, std::optional<std::filesystem::path> cachedModel) {
    if (load_ != nullptr) throw rtcore::Refusal("another scene is being loaded");
    rtcore::ImportOptions import = options_.import;
    rtcore::LightingOptions lighting = options_.lighting;
    if (document_.ready()) { // what was said of the first model
        import.up.reset();
        import.metresPerUnit.reset();
        import.pose.reset();
        lighting = {.usual = options_.lighting.usual};
    }
    load_ = std::make_unique<SceneLoad>(path, std::move(cachedModel), import, lighting, options_.threads);
}

std::optional<SceneUpkeep::Loaded> SceneUpkeep::takeLoaded() {
    if (load_ == nullptr || !load_->done()) return std::nullopt;
    const std::unique_ptr<SceneLoad> load = std::move(load_);
    try {
        show(load->take());
    } catch (const std::exception& error) {
        if (!document_.ready()) throw;
        messages_.complain(rtcore::sentenceOf(error));
        return Loaded{failureOf(error)};
    }
    return Loaded{};
}

void SceneUpkeep::show(std::unique_ptr<World> world) {
    document_.show(std::move(world));
    messages_.forget();
    rtcore::allowRegularFilesOnly(); // from here on paths come from clients
    tellModelUnits();
    const rtcore::LoadedScene& loaded = document_.world().loaded;
    if (!loaded.guesses.empty()) {
        const rtcore::Sentence said = rtcore::guessedText(loaded.guesses);
        Messages::print(rtcore::say("{0}: {1}", document_.title(), said));
        messages_.offer(rtcore::say(app::told::kMaterialOffer, said));
    }
    for (const rtcore::Sentence& warning : loaded.warnings) messages_.warn(warning);
}

void SceneUpkeep::tellModelUnits() {
    const rtcore::ModelUnits& units = document_.modelUnits();
    const rtcore::Sentence guess = app::guessText(units);
    if (guess.empty()) return;
    Messages::print(rtcore::say("{0}: {1}", document_.title(), guess));
    if (units.unitSaid == rtcore::Said::Guessed && units.metresPerUnit != 1)
        messages_.offer(
            rtcore::say(app::told::kUnitOffer, fmt::format("{}", units.metresPerUnit), units.unitWhy));
    if (!units.surprising) return;
    messages_.offer(rtcore::say(app::told::kUpOffer, rtcore::axisName(units.up), units.upWhy,
                                rtcore::axisName(units.otherUp)));
}

// Once indirect light is switched on.
void SceneUpkeep::tellFillLights() {
    const bool before =
        std::exchange(indirect_, document_.settings().indirect.mode == rtcore::IndirectMode::Live);
    if (!indirect_ || before) return;
    const std::shared_ptr<const rtcore::Scene> scene = document_.imagedScene();
    std::vector<std::string> names, commands;
    for (const rtcore::SceneLight* light : rtcore::fillLights(*scene)) {
        names.push_back(fmt::format("'{}'", light->name));
        commands.push_back(app::command::light(light->notes.id, false));
    }
    if (names.empty()) return;
    messages_.offer(rtcore::say(app::told::kFillOffer, fmt::format("{}", fmt::join(names, ", ")),
                                fmt::format("{}", fmt::join(commands, "; "))));
}

// --- What is kept of the scene ---

void SceneUpkeep::noticeChanges() {
    using rtcore::Change;
    const rtcore::Changes changes = changes_.take(document_.revisions());
    if (changes.has(Change::Scene)) {
        indirect_ = false;
        giveUp(std::move(refinement_));
        treeless_ = false;
    }
    if (changes.hasAny({Change::Scene, Change::Visibility})) {
        giveUp(std::move(visible_));
        prunedOnly_ = false;
    }
    noticeSections(changes.hasAny({Change::Scene, Change::Visibility}));
    tellFillLights();
    // Maps hold what stands where, and what light passes through it.
    const bool solid = changes.hasAny({Change::Scene, Change::Material, Change::Visibility, Change::Section});
    const bool lights = changes.has(Change::Light) && mapped_ != nullptr &&
                        !castAlike(mapped_->lights, document_.imagedScene()->lights);
    if (!solid && !lights) return;
    mapping_.reset();
    maps_.reset();
    mapped_.reset();
    mapless_ = false;
}

const rtcore::ShadowMaps* SceneUpkeep::shadowMaps() {
    noticeChanges();
    return maps_.get();
}

void SceneUpkeep::advance(const Pace& pace) {
    if (!document_.ready()) return;
    noticeChanges();
    std::erase_if(leaving_, [](const auto& each) { return each->done(); });
    refineTree(pace);
    buildVisible(pace);
    buildWithin(pace);
    mapShadows(pace);
}

// Its thread may need a while to notice, for which frames do not wait.
void SceneUpkeep::giveUp(std::unique_ptr<TreeRefinement> refinement) {
    if (refinement == nullptr) return;
    refinement->giveUp();
    leaving_.push_back(std::move(refinement));
}

void SceneUpkeep::refineTree(const Pace& pace) {
    if (refinement_ == nullptr) {
        // After the first frame, which nothing should slow down.
        if (!document_.world().loaded.fastTree || treeless_ || !pace.complete) return;
        const rtcore::LoadedScene& loaded = document_.world().loaded;
        refinement_ = std::make_unique<TreeRefinement>(loaded.scene, TreeRefinement::Part(),
                                                       loaded.tree.bounds, options_.threads);
    }
    if (!refinement_->done()) return;
    const std::unique_ptr<TreeRefinement> refinement = std::move(refinement_);
    try {
        TreeRefinement::Result result = refinement->take();
        document_.useTree(std::move(result.tree), std::move(result.tracer));
        Messages::print(
            rtcore::say("the exact kd-tree is in use; it took {0} s", shortNumber(result.seconds)));
    } catch (const std::bad_alloc&) { // then the fast one has to do
        treeless_ = true;
    }
}

// Soon, also while something moves, but after a first frame.
void SceneUpkeep::buildVisible(const Pace& pace) {
    if (visible_ == nullptr) {
        const bool needed = document_.visible().pruned() && !prunedOnly_;
        if (!needed || !pace.current || refinement_ != nullptr) return;
        const rtcore::Scene& scene = *document_.imagedScene();
        visible_ = std::make_unique<TreeRefinement>(scene, TreeRefinement::Part{scene.hiddenParts, {}},
                                                    document_.world().loaded.tree.bounds, options_.threads);
    }
    if (!visible_->done()) return;
    try {
        TreeRefinement::Result result = std::exchange(visible_, nullptr)->take();
        document_.useVisibleTree(std::move(result.tree), std::move(result.tracer), result.part.hidden);
        Messages::print(rtcore::say("the kd-tree of the visible parts is in use; it took {0} s",
                                    shortNumber(result.seconds)));
    } catch (const std::bad_alloc&) {
        prunedOnly_ = true;
    }
}

void SceneUpkeep::noticeSections(bool otherModel) {
    const std::span<const rtcore::HalfSpace> now = document_.visible().halves();
    if (!otherModel && rtcore::sameHalves(now, halves_)) return;
    giveUp(std::move(within_));
    halves_.assign(now.begin(), now.end());
    restsSince_.reset();
    reducedOnly_ = false;
}

// Once the planes rest: one that is moved has another tree in each frame. After the trees of which it is a
// part.
void SceneUpkeep::buildWithin(const Pace& pace) {
    constexpr double kRest = 0.3;
    if (!restsSince_) restsSince_ = pace.now;
    if (within_ == nullptr) {
        const VisibleModel& visible = document_.visible();
        const bool needed = visible.reduced() && !reducedOnly_ && pace.now - *restsSince_ >= kRest;
        const bool whole =
            !document_.world().loaded.fastTree && !visible.pruned() && !refinement_ && !visible_;
        if (!needed || !whole || !pace.current) return;
        const rtcore::Scene& scene = *document_.imagedScene();
        within_ = std::make_unique<TreeRefinement>(scene, TreeRefinement::Part{scene.hiddenParts, halves_},
                                                   visible.surfaces()->bounds(), options_.threads);
    }
    if (!within_->done()) return;
    try {
        const TreeRefinement::Result result = std::exchange(within_, nullptr)->take();
        document_.useTreeWithin(*result.tracer, result.part.hidden, result.part.halves);
    } catch (const std::bad_alloc&) { // then the reduced one has to do
        reducedOnly_ = true;
    }
}

// Where whole frames are not quick enough to be seen at once: while nothing else is to do; or soon, where not
// even the coarsest are.
void SceneUpkeep::mapShadows(const Pace& pace) {
    if (maps_ != nullptr) return;
    if (mapping_ == nullptr) {
        const double quick = pace.wanted;
        const bool needed = quick > 0 && (pace.coarsest > quick || (pace.idle && pace.seconds > quick));
        if (mapless_ || !needed || document_.world().loaded.fastTree) return;
        mapped_ = document_.imagedScene();
        mapping_ = std::make_unique<ShadowMapping>(mapped_, document_.tracer());
    }
    if (!mapping_->done()) return;
    try {
        maps_ = std::exchange(mapping_, nullptr)->take();
    } catch (const std::bad_alloc&) { // then without
    }
    mapless_ = maps_ == nullptr;
}

} // namespace rtserver

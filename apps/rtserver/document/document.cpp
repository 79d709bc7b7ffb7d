#include "rtserver/document/document.h"

#include "rtserver/document/opening.h"

#include "common/settings/settings_merge.h"

#include "rtcore/look/light_units.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/settings_table.h"
#include "rtcore/sky/scene_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace rtserver {

namespace {

constexpr int kBloomRadius = 16; ///< pixels, where none was set

/// The kinds of an edit that made the one of the other.
rtcore::Changes changesBetween(const rtcore::Scene& before, const rtcore::Scene& after) {
    rtcore::Changes changes;
    changes.set(rtcore::Change::Light,
                !rtcore::shineAlike(after.lights, before.lights) || after.ambient != before.ambient);
    changes.set(rtcore::Change::Sky, after.background != before.background ||
                                         after.activeEnvironment != before.activeEnvironment ||
                                         after.environments != before.environments);
    changes.set(rtcore::Change::Material, after.materials != before.materials);
    changes.set(rtcore::Change::Section,
                after.sections != before.sections || !rtcore::sameParts(after.uncutParts, before.uncutParts));
    changes.set(rtcore::Change::Visibility, !rtcore::sameParts(after.hiddenParts, before.hiddenParts));
    return changes;
}

bool showAlike(const rtcore::Scene& before, const rtcore::Scene& after) {
    return !changesBetween(before, after).any() && before.lights == after.lights;
}

} // namespace

Document::Document(const Options& options, Reserve reserve, Messages& messages)
    : options_(options), reserve_(std::move(reserve)), messages_(messages), lastBloomRadius_(kBloomRadius) {}

std::string Document::title() const { return world_->source.filename().string(); }

void Document::show(std::unique_ptr<World> world) {
    Opening opening = openingOf(*world, options_, ready() ? &settings_ : nullptr);
    reserve_(opening.settings);
    settings_ = opening.settings;
    world_ = std::move(world);
    scene_ = std::make_shared<const rtcore::Scene>(std::move(opening.scene));
    imageScene();
    visible_.prune(*world_, *scene_);
    camera_ = world_->loaded.camera;
    revisions_.note(rtcore::Changes::all());
    bookmarks_ = std::make_shared<const rtcore::SceneBookmarks>(world_->loaded.bookmarks);
    const std::optional<rtcore::SceneFile>& file = world_->loaded.sceneFile;
    measures_ = std::make_shared<const rtcore::KeptMeasures>(file ? file->measures : rtcore::KeptMeasures());
    notes_ = std::make_shared<const rtcore::SceneNotes>(file ? file->notes : rtcore::SceneNotes());
    flights_ = std::make_shared<const rtcore::Flights>(file ? file->flights : rtcore::Flights());
    variants_ = std::make_shared<const VariantBook>(std::move(opening.variants));
    history_.clear();
    savedState_ = history_.state();
    if (follower_ != nullptr) follower_->sceneOpened();
}

// --- What is traced ---

void Document::useTree(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer) {
    world_->loaded.tree = std::move(tree);
    world_->loaded.fastTree = false;
    world_->tracer = std::move(tracer);
    if (scene_->hiddenParts != nullptr && !visible_.pruned()) return;
    visible_.prune(*world_, *scene_);
    if (follower_ != nullptr) follower_->treeReplaced();
}

void Document::useVisibleTree(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer,
                              const rtcore::HiddenParts& hidden) {
    if (!rtcore::sameParts(hidden, scene_->hiddenParts)) return;
    visible_.replace(std::move(tree), std::move(tracer), *scene_);
    if (follower_ != nullptr) follower_->treeReplaced();
}

void Document::useTreeWithin(const rtcore::KdRayTracer& built, const rtcore::HiddenParts& hidden,
                             std::span<const rtcore::HalfSpace> halves) {
    if (rtcore::sameParts(hidden, scene_->hiddenParts)) visible_.useWithin(built, halves, *scene_);
}

// --- Scene ---

void Document::putScene(rtcore::Scene edited) {
    scene_ = std::make_shared<const rtcore::Scene>(std::move(edited));
    imageScene();
    visible_.take(*scene_);
}

void Document::imageScene() {
    auto inOneUnit = settings_.falseColours.on ? rtcore::inUnitOfSky(*scene_) : std::nullopt;
    imaged_ = inOneUnit ? std::make_shared<const rtcore::Scene>(std::move(*inOneUnit)) : scene_;
}

void Document::publish(rtcore::Scene edited) {
    const rtcore::Changes changes = changesBetween(*scene_, edited);
    if (showAlike(*scene_, edited)) return;
    const std::shared_ptr<const rtcore::Scene> before = scene_;
    putScene(std::move(edited));
    revisions_.note(changes);
    if (changes.has(rtcore::Change::Visibility)) visible_.prune(*world_, *scene_);
    if (follower_ != nullptr) follower_->sceneEdited(*before, changes);
}

void Document::setModelUnits(std::optional<rtcore::Vec3> up, std::optional<double> metresPerUnit) {
    useModelUnits(rtcore::withUserSays(modelUnits(), up, metresPerUnit));
    if (up) messages_.withdrawOffers();
}

void Document::guessModelUnits(bool up, bool unit) {
    const rtcore::LoadedScene& loaded = world_->loaded;
    const rtcore::ModelUnits guess = rtcore::guessModelUnits(loaded.origin, loaded.tree, loaded.scene.model);
    rtcore::ModelUnits units = modelUnits();
    if (up) {
        units.up = guess.up;
        units.otherUp = guess.otherUp;
        units.upSaid = guess.upSaid;
        units.upWhy = guess.upWhy;
    }
    if (unit) {
        units.metresPerUnit = guess.metresPerUnit;
        units.unitSaid = guess.unitSaid;
        units.unitWhy = guess.unitWhy;
    }
    useModelUnits(units);
}

void Document::useModelUnits(const rtcore::ModelUnits& units) {
    rtcore::Scene edited = *scene_;
    rtcore::Camera camera = camera_;
    const bool same = units.up == edited.up && units.metresPerUnit == edited.metresPerUnit;
    rtcore::applyModelUnits(world_->loaded, units, edited, camera);
    if (same) return;
    rtcore::Changes changes{rtcore::Change::View, rtcore::Change::Sky, rtcore::Change::Setting};
    changes.set(rtcore::Change::Light, !rtcore::shineAlike(edited.lights, scene_->lights));
    putScene(std::move(edited));
    variants_ = std::make_shared<const VariantBook>(inUnits(*variants_, units));
    camera_ = camera;
    revisions_.note(changes);
    if (follower_ != nullptr) follower_->unitsChanged();
}

// --- Camera ---

void Document::setCamera(const rtcore::Camera& camera) {
    const bool finite = isFinite(camera.eye) && isFinite(camera.forward) && isFinite(camera.up);
    if (!finite || normalize(camera.forward) == rtcore::Vec3{})
        throw rtcore::BadValue("the camera needs a direction to look in");
    if (normalize(camera.up) == rtcore::Vec3{} || rtcore::areParallel(camera.forward, camera.up))
        throw rtcore::BadValue("the direction that is up must be another one than that to look in");
    if (!(camera.horizontalFov > 0 && camera.horizontalFov < 180))
        throw rtcore::BadValue("the field of view is more than 0 and less than 180 degrees");
    if (camera.kind == rtcore::CameraKind::Orthographic && !(camera.orthographicWidth > 0))
        throw rtcore::BadValue("the width of an orthographic view is more than 0");
    placeCamera(camera);
}

void Document::placeCamera(const rtcore::Camera& camera) {
    moveCamera(camera);
    if (follower_ != nullptr) follower_->cameraPlaced();
}

void Document::moveCamera(const rtcore::Camera& camera) {
    if (camera != camera_) revisions_.note({rtcore::Change::View});
    camera_ = camera;
}

rtcore::Sentence Document::applyCameraFile(const rtcore::CameraFile& file,
                                           const std::filesystem::path& path) {
    const std::vector<rtcore::SettingAssignment> now = rtcore::settingAssignments(settings_, true);
    rtcore::Scene edited = *scene_;
    rtcore::Sentence warning = app::applyCameraToScene(file, path, edited);
    setSettings(app::mergeSettings({.scene = now, .camera = &file}));
    publish(std::move(edited));
    placeCamera(file.camera);
    return warning;
}

void Document::setBookmarks(rtcore::SceneBookmarks bookmarks) {
    if (bookmarks == *bookmarks_) return;
    bookmarks_ = std::make_shared<const rtcore::SceneBookmarks>(std::move(bookmarks));
}

void Document::setMeasures(rtcore::KeptMeasures measures) {
    if (measures == *measures_) return;
    measures_ = std::make_shared<const rtcore::KeptMeasures>(std::move(measures));
}

void Document::setNotes(rtcore::SceneNotes notes) {
    if (notes == *notes_) return;
    notes_ = std::make_shared<const rtcore::SceneNotes>(std::move(notes));
}

void Document::setFlights(rtcore::Flights flights) {
    if (flights == *flights_) return;
    flights_ = std::make_shared<const rtcore::Flights>(std::move(flights));
}

void Document::setVariants(VariantBook variants) {
    if (variants == *variants_) return;
    variants_ = std::make_shared<const VariantBook>(std::move(variants));
}

void Document::addToAllNotes(const rtcore::SceneNote& note) {
    using Notes = std::shared_ptr<const rtcore::SceneNotes>;
    std::map<Notes, Notes> with; // steps have most of them in common
    const auto full = [](const Notes& notes) { return notes->size() >= rtcore::kMaxNotes; };
    if (full(notes_) || history_.hasNotes(full))
        throw rtcore::Refusal(rtcore::say(
            "there are {0} notes, or were before an edit that can be taken back", rtcore::kMaxNotes));
    const auto withNote = [&](const Notes& notes) {
        Notes& extended = with[notes];
        if (extended == nullptr) {
            rtcore::SceneNotes all = *notes;
            all.push_back(note);
            extended = std::make_shared<const rtcore::SceneNotes>(std::move(all));
        }
        return extended;
    };
    notes_ = withNote(notes_);
    history_.replaceNotes(withNote);
}

// --- Settings ---

void Document::setSettings(const rtcore::RenderSettings& settings) {
    rtcore::checkLive(settings);
    if (settings.width != settings_.width || settings.height != settings_.height) reserve_(settings);
    takeSettings(settings);
}

void Document::takeSettings(const rtcore::RenderSettings& settings) {
    if (rtcore::settingAssignments(settings, true) != rtcore::settingAssignments(settings_, true))
        revisions_.note({rtcore::Change::Setting});
    const bool other = settings.falseColours.on != settings_.falseColours.on;
    settings_ = settings;
    if (!other || !ready()) return;
    const rtcore::Sentence warning = rtcore::unitWarning(rtcore::unitlessLight(*scene_, settings_));
    if (settings_.falseColours.on && !warning.empty()) messages_.warn(warning);
    const auto before = imaged_;
    imageScene();
    if (imaged_ != before) // light that is kept is in another unit
        revisions_.note({rtcore::Change::Light, rtcore::Change::Sky, rtcore::Change::Material});
}

void Document::assign(const std::vector<rtcore::SettingAssignment>& assignments) {
    rtcore::RenderSettings settings = settings_;
    rtcore::applySettings(settings, assignments);
    setSettings(settings);
}

void Document::switchBloom(bool on) {
    if ((settings_.bloom.radius != 0) == on) return;
    if (!on) lastBloomRadius_ = settings_.bloom.radius;
    rtcore::RenderSettings settings = settings_;
    settings.bloom.radius = on ? lastBloomRadius_ : 0;
    takeSettings(settings);
}

void Document::setPlayedExposure(std::optional<float> exposure) {
    if (exposure != playedExposure_) revisions_.note({rtcore::Change::Setting});
    playedExposure_ = exposure;
}

rtcore::RenderSettings Document::frameSettings() const {
    rtcore::RenderSettings settings = settings_;
    if (playedExposure_) {
        settings.exposure.mode = rtcore::ExposureMode::Fixed;
        settings.exposure.value = *playedExposure_;
    }
    return settings;
}

// --- Steps ---

// A gesture that has come back to where it began leaves no step: scenes are told apart by where they are.
void Document::keepStep(std::string label, Snapshot before, const EditAuthor& by, bool goesOn) {
    Snapshot after = snapshot();
    const EditStep* const last = history_.last();
    if (goesOn && last != nullptr && after.modelUnits.up == last->before.modelUnits.up &&
        after.modelUnits.metresPerUnit == last->before.modelUnits.metresPerUnit &&
        showAlike(*last->before.scene, *after.scene))
        after.scene = last->before.scene;
    history_.add({std::move(label), std::move(before), std::move(after), by}, goesOn);
}

// Windows change the size as well: it goes back only where it still is what the step made it.
void Document::makeOf(const EditStep& step, const Snapshot& from, const Snapshot& to) {
    if (changesSettings(step)) {
        rtcore::RenderSettings settings = to.settings;
        if (settings_.width != from.settings.width || settings_.height != from.settings.height) {
            settings.width = settings_.width;
            settings.height = settings_.height;
        }
        setSettings(settings);
    }
    if (changesModelUnits(step)) useModelUnits(to.modelUnits);
    if (changesScene(step)) publish(rtcore::withSkyMap(*to.scene, scene_.get()));
    if (changesBookmarks(step)) bookmarks_ = to.bookmarks;
    if (changesMeasures(step)) measures_ = to.measures;
    if (changesNotes(step)) notes_ = to.notes;
    if (changesFlights(step)) flights_ = to.flights;
    if (changesVariants(step)) variants_ = to.variants;
    if (changesCamera(step) || changesModelUnits(step)) setCamera(to.camera);
}

std::string Document::undo(std::optional<int> number) {
    const EditStep* const step = history_.last();
    if (step == nullptr) throw rtcore::Refusal("there is nothing to undo");
    if (number && step->number != *number)
        throw rtcore::Refusal(rtcore::say("edit {0} is not the last one", *number));
    makeOf(*step, step->after, step->before);
    history_.moveBack();
    return step->label;
}

std::string Document::redo(std::optional<int> number) {
    const EditStep* const step = history_.next();
    if (step == nullptr) throw rtcore::Refusal("there is nothing to redo");
    if (number && step->number != *number)
        throw rtcore::Refusal(rtcore::say("edit {0} is not the one that was taken back", *number));
    makeOf(*step, step->before, step->after);
    history_.moveForth();
    return step->label;
}

void Document::noteSaved(const std::filesystem::path& path, std::uint64_t historyState) {
    if (historyState < history_.firstState()) return;
    savedState_ = historyState;
    world_->source = path;
    addInput(path);
}

} // namespace rtserver

#include "rtserver/document.h"

#include "common/settings/settings_merge.h"

#include "rtcore/io/text/set.h"
#include "rtcore/motion/player.h"
#include "rtcore/render/ground_tracer.h"
#include "rtcore/render/visible_scene.h"
#include "rtcore/scene/material_edit.h"
#include "rtcore/settings/settings_table.h"
#include "rtcore/sky/scene_sky.h"

#include <fmt/format.h>

#include <numbers>
#include <stdexcept>
#include <utility>

namespace rtserver {

namespace {

constexpr int kBloom = 16; ///< radius in pixels, where none was set

// For users they are counted from 1.
[[noreturn]] void refuseNumber(const std::string& what, int index, std::size_t count) {
    const std::string has = count == 0   ? "none"
                            : count == 1 ? "only number 1"
                                         : fmt::format("numbers 1 to {}", count);
    throw std::invalid_argument(fmt::format("there is no {} {}; the scene has {}", what, index + 1, has));
}

} // namespace

ServerState::ServerState(const Options& options, Reserve reserve, Messages& messages)
    : frameSeconds(options.frameSeconds), options_(options), reserve_(std::move(reserve)),
      messages_(messages), bloom_(kBloom) {}

ServerState::~ServerState() = default;

std::string ServerState::title() const { return world_->source.filename().string(); }

rtcore::RenderSettings ServerState::settingsOf(const World& world, const rtcore::CameraFile* camera) const {
    std::vector<rtcore::SettingAssignment> file;
    if (options_.settingsFile) file = rtcore::readSettingsFile(*options_.settingsFile).live;
    rtcore::RenderSettings settings = app::mergeSettings({.scene = world.loaded.live,
                                                          .settingsFile = file,
                                                          .camera = camera,
                                                          .commandLine = options_.settings});
    if (world_ != nullptr) {
        settings.width = settings_.width;
        settings.height = settings_.height;
    }
    return settings;
}

void ServerState::show(std::unique_ptr<World> world) {
    const bool first = world_ == nullptr;
    rtcore::LoadedScene& loaded = world->loaded;
    rtcore::numberLights(loaded.scene);
    rtcore::Scene scene = loaded.scene;
    rtcore::useGuesses(scene, loaded.guesses);
    std::optional<rtcore::CameraFile> camera;
    std::filesystem::path path;
    if (first && options_.camera) path = *options_.camera;
    if (path.empty() && loaded.sceneFile && loaded.sceneFile->cameraFile)
        path = *loaded.sceneFile->cameraFile;
    if (!path.empty()) {
        camera = rtcore::readCameraFile(path);
        const std::string warning = app::applyCameraToScene(*camera, path, scene);
        if (!warning.empty()) loaded.warnings.push_back(warning);
        loaded.camera = camera->camera;
    }
    if (first) {
        app::selectParts(options_.selection, scene);
        app::selectLights(options_.selection, scene);
    }
    // A .bsp may have one that setCamera() refuses.
    if (rtcore::areParallel(loaded.camera.forward, loaded.camera.up))
        loaded.camera.up = rtcore::upwardsOf(loaded.camera.forward, scene.up);
    const rtcore::RenderSettings settings = settingsOf(*world, camera ? &*camera : nullptr);
    reserve_(settings);
    settings_ = settings;
    stopPlaying();
    if (recording_) endRecording("another scene was shown");
    player_.reset();
    pivot_.reset();
    world_ = std::move(world);
    scene_ = std::make_shared<const rtcore::Scene>(std::move(scene));
    makeTree();
    makePlayer(loaded.camera);
    revisions_.note(rtcore::Changes::all());
    bookmarks_ = std::make_shared<const rtcore::SceneBookmarks>(world_->loaded.bookmarks);
    history_.clear();
    savedState_ = history_.state();
    if (first && options_.path) play(std::make_unique<Playback>(*options_.path));
}

void ServerState::makePlayer(const rtcore::Camera& camera) {
    const rtcore::LoadedScene& loaded = world_->loaded;
    player_ = std::make_unique<rtcore::Player>(
        tree_, loaded.scene.model.mesh,
        rtcore::PlayerOptions{
            .up = scene_->up, .metresPerUnit = double{scene_->metresPerUnit}, .walk = scene_->walk});
    player_->setCamera(camera);
    camera_ = player_->camera();
}

const rtcore::UpAndUnit& ServerState::frame() const { return world_->loaded.frame; }

void ServerState::setFrame(std::optional<rtcore::Vec3> up, std::optional<double> metresPerUnit) {
    useFrame(rtcore::withUserSays(world_->loaded.frame, up, metresPerUnit));
    if (up) messages_.withdrawOffers();
}

void ServerState::guessFrame(bool up, bool unit) {
    const rtcore::LoadedScene& loaded = world_->loaded;
    const rtcore::UpAndUnit guess = rtcore::guessUpAndUnit(loaded.origin, loaded.tree, loaded.scene.model);
    rtcore::UpAndUnit frame = loaded.frame;
    if (up) {
        frame.up = guess.up;
        frame.otherUp = guess.otherUp;
        frame.upSaid = guess.upSaid;
        frame.upWhy = guess.upWhy;
    }
    if (unit) {
        frame.metresPerUnit = guess.metresPerUnit;
        frame.unitSaid = guess.unitSaid;
        frame.unitWhy = guess.unitWhy;
    }
    useFrame(frame);
}

// What is recorded and what is walked on is of the old frame.
void ServerState::useFrame(const rtcore::UpAndUnit& frame) {
    rtcore::Scene edited = *scene_;
    rtcore::Camera camera = camera_;
    const bool same = frame.up == edited.up && frame.metresPerUnit == edited.metresPerUnit;
    rtcore::reframe(world_->loaded, frame, edited, camera);
    if (same) return;
    stopPlaying();
    if (recording_) endRecording("the up axis or the unit was changed");
    rtcore::Changes changes{rtcore::Change::View, rtcore::Change::Sky, rtcore::Change::Setting};
    changes.set(rtcore::Change::Light, !rtcore::shineAlike(edited.lights, scene_->lights));
    putScene(std::move(edited));
    const double speed = player_->speedFactor();
    makePlayer(camera);
    player_->setSpeedFactor(speed);
    revisions_.note(changes);
}

void ServerState::useTree(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer) {
    world_->loaded.tree = std::move(tree);
    world_->loaded.fastTree = false;
    world_->tracer = std::move(tracer);
    if (scene_->hiddenParts != nullptr && !prunes_) return;
    makeTree();
    player_->useTree(tree_);
}

void ServerState::useVisibleTree(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer,
                                 const rtcore::HiddenParts& hidden) {
    if (!rtcore::sameHidden(hidden, scene_->hiddenParts)) return;
    tree_ = std::move(tree);
    surfaces_ = std::move(tracer);
    tracer_ = rtcore::withGround(surfaces_, *scene_);
    prunes_ = false;
    player_->useTree(tree_);
}

void ServerState::makeTree() {
    const rtcore::LoadedScene& loaded = world_->loaded;
    tree_ = rtcore::visibleTree(loaded.tree, *scene_);
    prunes_ = scene_->hiddenParts != nullptr;
    surfaces_ =
        prunes_ ? std::make_shared<const rtcore::KdRayTracer>(tree_, *world_->tracer) : world_->tracer;
    tracer_ = rtcore::withGround(surfaces_, *scene_);
}

void ServerState::setCamera(const rtcore::Camera& camera) {
    const bool finite = isFinite(camera.eye) && isFinite(camera.forward) && isFinite(camera.up);
    if (!finite || normalize(camera.forward) == rtcore::Vec3{})
        throw std::invalid_argument("the camera needs a direction to look in");
    if (normalize(camera.up) == rtcore::Vec3{} || rtcore::areParallel(camera.forward, camera.up))
        throw std::invalid_argument("the direction that is up must be another one than that to look in");
    if (!(camera.horizontalFov > 0 && camera.horizontalFov < 180))
        throw std::invalid_argument("the field of view is more than 0 and less than 180 degrees");
    if (camera.kind == rtcore::CameraKind::Orthographic && !(camera.orthographicWidth > 0))
        throw std::invalid_argument("the width of an orthographic view is more than 0");
    stopPlaying();
    player_->setCamera(camera);
    takeCamera();
}

void ServerState::setSettings(const rtcore::RenderSettings& settings) {
    rtcore::checkLive(settings);
    if (settings.width != settings_.width || settings.height != settings_.height) reserve_(settings);
    takeSettings(settings);
}

void ServerState::goBackTo(const rtcore::RenderSettings& settings) { takeSettings(settings); }

void ServerState::takeSettings(const rtcore::RenderSettings& settings) {
    if (rtcore::settingAssignments(settings, true) != rtcore::settingAssignments(settings_, true))
        revisions_.note({rtcore::Change::Setting});
    settings_ = settings;
}

rtcore::RenderSettings ServerState::shownSettings() const {
    rtcore::RenderSettings settings = settings_;
    if (shown_ && shown_->exposure) {
        settings.exposure.mode = rtcore::ExposureMode::Fixed;
        settings.exposure.value = *shown_->exposure;
    }
    return settings;
}

void ServerState::switchBloom(bool on) {
    if ((settings_.bloom.radius != 0) == on) return;
    if (!on) bloom_ = settings_.bloom.radius;
    rtcore::RenderSettings settings = settings_;
    settings.bloom.radius = on ? bloom_ : 0;
    takeSettings(settings);
}

void ServerState::putScene(rtcore::Scene edited) {
    scene_ = std::make_shared<const rtcore::Scene>(std::move(edited));
    tracer_ = rtcore::withGround(surfaces_, *scene_);
}

void ServerState::publish(rtcore::Scene edited) {
    rtcore::Changes changes;
    changes.set(rtcore::Change::Light,
                !rtcore::shineAlike(edited.lights, scene_->lights) || edited.ambient != scene_->ambient);
    changes.set(rtcore::Change::Sky, edited.background != scene_->background ||
                                         edited.activeEnvironment != scene_->activeEnvironment ||
                                         edited.environments != scene_->environments);
    changes.set(rtcore::Change::Material, edited.materials != scene_->materials);
    changes.set(rtcore::Change::Visibility, !rtcore::sameHidden(edited.hiddenParts, scene_->hiddenParts));
    const bool renamed = edited.lights != scene_->lights;
    if (!changes.any() && !renamed) return;
    endOutdatedRecording(edited);
    putScene(std::move(edited));
    revisions_.note(changes);
    if (changes.has(rtcore::Change::Visibility)) useVisible();
}

// What carries a walker, and where it falls, is found anew.
void ServerState::useVisible() {
    makeTree();
    player_->useTree(tree_);
    if (!walking()) return;
    player_->setMode(rtcore::MotionMode::View);
    player_->setMode(rtcore::MotionMode::Walk);
    takeCamera();
}

std::string ServerState::applyCameraFile(const rtcore::CameraFile& file, const std::filesystem::path& path) {
    const std::vector<rtcore::SettingAssignment> now = rtcore::settingAssignments(settings_, true);
    rtcore::Scene edited = *scene_;
    std::string warning = app::applyCameraToScene(file, path, edited);
    setSettings(app::mergeSettings({.scene = now, .camera = &file}));
    publish(std::move(edited));
    stopPlaying();
    player_->setCamera(file.camera);
    takeCamera();
    return warning;
}

void ServerState::assign(const std::vector<rtcore::SettingAssignment>& assignments) {
    rtcore::RenderSettings settings = settings_;
    rtcore::applySettings(settings, assignments);
    setSettings(settings);
}

void ServerState::setEnvironment(int environment) {
    rtcore::Scene edited = *scene_;
    if (environment < 0 || static_cast<std::size_t>(environment) >= edited.environments.size())
        refuseNumber("environment", environment, edited.environments.size());
    edited.activeEnvironment = environment;
    publish(std::move(edited));
}

void ServerState::setBookmarks(rtcore::SceneBookmarks bookmarks) {
    if (bookmarks == *bookmarks_) return;
    bookmarks_ = std::make_shared<const rtcore::SceneBookmarks>(std::move(bookmarks));
}

void ServerState::noteSaved(const std::filesystem::path& path, std::uint64_t historyState) {
    if (historyState < history_.firstState()) return;
    savedState_ = historyState;
    world_->source = path;
    world_->inputs.add(path);
}

void ServerState::editMaterials(std::span<const std::size_t> materials,
                                const rtcore::MaterialOverride& change) {
    rtcore::Scene edited = *scene_;
    for (const std::size_t material : materials)
        rtcore::editMaterial(edited, world_->loaded.scene.materials, material, change);
    rtcore::closeSurfaces(edited, scene_->materials);
    publish(std::move(edited));
}

void ServerState::resetMaterials(std::span<const std::size_t> materials) {
    rtcore::Scene edited = *scene_;
    for (const std::size_t material : materials)
        rtcore::resetMaterial(edited, world_->loaded.scene.materials, material);
    rtcore::closeSurfaces(edited, scene_->materials);
    publish(std::move(edited));
}

void ServerState::hideParts(rtcore::HiddenParts hidden) {
    rtcore::Scene edited = *scene_;
    edited.hiddenParts = std::move(hidden);
    publish(std::move(edited));
}

void ServerState::keepStep(std::string label, Shown before, const EditAuthor& by, bool goesOn) {
    history_.add({std::move(label), std::move(before), shown(), by}, goesOn);
}

// Windows change the size as well: it goes back only where it still is what the step made it.
void ServerState::makeOf(const EditStep& step, const Shown& from, const Shown& to) {
    if (changesSettings(step)) {
        rtcore::RenderSettings settings = to.settings;
        if (settings_.width != from.settings.width || settings_.height != from.settings.height) {
            settings.width = settings_.width;
            settings.height = settings_.height;
        }
        setSettings(settings);
    }
    if (changesFrame(step)) useFrame(to.frame);
    if (changesScene(step)) publish(rtcore::withSkyMap(*to.scene, scene_.get()));
    if (changesBookmarks(step)) bookmarks_ = to.bookmarks;
    if (changesCamera(step) || changesFrame(step)) setCamera(to.camera);
}

std::string ServerState::undo(std::optional<int> number) {
    const EditStep* const step = history_.last();
    if (step == nullptr) throw std::runtime_error("there is nothing to undo");
    if (number && step->number != *number)
        throw std::runtime_error(fmt::format("edit {} is not the last one", *number));
    makeOf(*step, step->after, step->before);
    history_.moveBack();
    return step->label;
}

std::string ServerState::redo(std::optional<int> number) {
    const EditStep* const step = history_.next();
    if (step == nullptr) throw std::runtime_error("there is nothing to redo");
    if (number && step->number != *number)
        throw std::runtime_error(fmt::format("edit {} is not the one that was taken back", *number));
    makeOf(*step, step->before, step->after);
    history_.moveForth();
    return step->label;
}

void ServerState::turn(double right, double upwards) {
    constexpr double kRadians = std::numbers::pi / 180;
    stopPlaying();
    player_->look(right * kRadians, upwards * kRadians);
    takeCamera();
}

bool ServerState::onUnseenFloor() const { return player_->onUnseenFloor(); }

void ServerState::setSpeed(double factor) { player_->setSpeedFactor(factor); }

bool ServerState::walking() const { return player_->mode() == rtcore::MotionMode::Walk; }

float ServerState::metresPerUnit() const { return scene_->metresPerUnit; }

void ServerState::takeCamera() {
    const rtcore::Camera camera = player_->camera();
    if (camera != camera_) revisions_.note({rtcore::Change::View});
    camera_ = camera;
}

} // namespace rtserver

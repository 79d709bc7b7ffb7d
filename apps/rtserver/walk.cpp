// What moves by itself: the player, keys that are pressed for a time, a path that is recorded or played.
#include "rtserver/document.h"
#include "rtserver/exports.h"
#include "rtserver/messages.h"

#include "common/commands/key_restraint.h"
#include "common/settings/settings_merge.h"

#include "rtcore/look/doorstep.h"
#include "rtcore/motion/player.h"
#include "rtcore/motion/walk_shape.h"
#include "rtcore/platform/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rtserver {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

namespace {
constexpr nanoseconds kLongestTurn = 250ms; ///< longest step, so that a stall causes no leap

/// As a player who is larger or smaller than a person sees the model: in metres of his own.
rtcore::Axes axesOfPlayer(const rtcore::Scene& scene) {
    const auto usual = static_cast<float>(rtcore::WalkShape().stand.height);
    const auto height = static_cast<float>(rtcore::WalkShape(scene.walk).stand.height);
    return rtcore::Axes(scene.up, scene.metresPerUnit * usual / height);
}

std::string tooSmallToWalk(const rtcore::Survey& found, float metresPerUnit) {
    const float height = rtcore::extentAlong(found.subject.bounds, found.axes.up) * metresPerUnit;
    return fmt::format("the model is too small to walk: it is {:.2g} m high; 'units' says how large it is",
                       height);
}

} // namespace

void ServerState::move(nanoseconds time, const ipc::KeyState& clientKeys) {
    nanoseconds left = std::clamp<nanoseconds>(time, 0ns, kLongestTurn);
    while (true) {
        takeRecordedView();
        if (left == 0ns) break;
        const nanoseconds step = std::clamp<nanoseconds>(untilEvent(), 1ns, left);
        advance(step);
        left -= step;
    }
    press(clientKeys);
    takeCamera();
}

void ServerState::advance(nanoseconds step) {
    player_->advance(step);
    if (keyboard_.advance(step)) hold();
    if (recording_) recording_->advance(step);
    if (!playback_) return;
    if (const std::optional<Playback::Shot> shot = playback_->advance(step)) show(*shot);
    if (playback_ && playback_->ended()) stopPlaying();
}

void ServerState::press(const ipc::KeyState& clientKeys) {
    clientKeys_ = clientKeys.down;
    ipc::KeyState keys = clientKeys;
    keyboard_.collect(keys);
    const auto before = std::exchange(lastDown_, keys.down);
    const auto withheld = [&](const rtcore::KeyBinding& binding) -> std::uint32_t {
        const auto level = static_cast<std::size_t>(app::withheldFrom(binding.action));
        return level == 0 ? 0 : clientKeys.restrained[level - 1][static_cast<std::size_t>(binding.key)];
    };
    for (const rtcore::ActionTap& tap : bindings_.taps(keys.down, keys.presses, before, withheld)) apply(tap);
    hold();
}

void ServerState::hold() {
    const rtcore::ActionSet actions = bindings_.held(clientKeys_ | keyboard_.down());
    if (!actions.none()) stopPlaying(); // a movement ends the playback
    player_->hold(actions);
}

void ServerState::apply(const rtcore::ActionTap& tap) {
    if (rtcore::isHeld(tap.action)) {
        stopPlaying();
        player_->tap(tap.action);
    } else if (tap.action == rtcore::Action::ToggleWalk) {
        toggleWalking();
    } else if (tap.action == rtcore::Action::ToggleBloom) {
        const Shown before = shown();
        switchBloom(settings_.bloom.radius == 0);
        keepStep("bloom", before);
        messages_.tell(settings_.bloom.radius == 0 ? "bloom off" : "bloom on");
    } else if (tap.action == rtcore::Action::ToggleLight) {
        toggleLight(tap.number);
    } else if (tap.action == rtcore::Action::SelectEnvironment) {
        chooseEnvironment(tap.number - 1);
    }
}

void ServerState::toggleWalking() {
    try {
        setWalking(!walking());
        messages_.tell(onUnseenFloor() ? kUnseenFloor : walking() ? "walking" : "flying");
    } catch (const std::runtime_error& error) {
        messages_.tell(error.what());
    }
}

// A key for a light that the scene lacks is a message, not an error.
void ServerState::toggleLight(int id) {
    const std::string name = fmt::format("light {}", id);
    const std::optional<std::size_t> light = rtcore::lightWithId(*scene_, id);
    if (!light) return messages_.tell("there is no " + name);
    const Shown before = shown();
    switchLight(id, std::nullopt);
    keepStep(name, before);
    messages_.tell(name + (scene_->lights[*light].light.on != 0 ? " on" : " off"));
}

void ServerState::chooseEnvironment(int environment) {
    const std::string name = fmt::format("environment {}", environment + 1);
    if (environment < 0 || std::cmp_greater_equal(environment, scene_->environments.size()))
        return messages_.tell("there is no " + name);
    const Shown before = shown();
    setEnvironment(environment);
    keepStep(name, before);
    messages_.tell(name);
}

void ServerState::setWalking(bool walking) {
    stopPlaying();
    if (walking && !this->walking()) beginWalking();
    if (!walking) player_->setMode(rtcore::MotionMode::View);
    takeCamera();
}

// One who looks from above or from afar begins before the model, and faces it.
void ServerState::beginWalking() {
    const rtcore::Mesh& mesh = scene_->model.mesh;
    const rtcore::Survey found = rtcore::survey(tree_, mesh, axesOfPlayer(*scene_));
    if (rtcore::isTooSmallToWalk(found))
        throw std::runtime_error(tooSmallToWalk(found, scene_->metresPerUnit));
    const rtcore::Camera before = player_->camera();
    if (rtcore::hoversOutside(tree_, mesh, found, before.eye)) {
        for (const rtcore::Camera& camera : rtcore::doorsteps(tree_, mesh, found, before)) {
            player_->setCamera(camera);
            if (player_->setMode(rtcore::MotionMode::Walk)) return;
        }
        player_->setCamera(before);
    }
    if (!player_->setMode(rtcore::MotionMode::Walk))
        throw std::runtime_error("there is no room to stand here, or no floor below; move elsewhere first");
}

rtcore::Vec3 ServerState::pivot() {
    if (pivot_) return *pivot_;
    const rtcore::Box3 bounds = rtcore::subjectOf(scene_->model.mesh, rtcore::axesOf(*scene_)).bounds;
    pivot_ = bounds.empty() ? rtcore::Vec3{} : bounds.centre();
    return *pivot_;
}

void ServerState::resetCamera() {
    const bool walked = walking();
    player_->setMode(rtcore::MotionMode::View);
    setCamera(world_->loaded.camera);
    const rtcore::Survey found = rtcore::survey(tree_, scene_->model.mesh, axesOfPlayer(*scene_));
    if (walked && !rtcore::hoversOutside(tree_, scene_->model.mesh, found, camera_.eye))
        player_->setMode(rtcore::MotionMode::Walk);
    takeCamera();
}

nanoseconds ServerState::untilEvent() const {
    nanoseconds until = keyboard_.untilRelease();
    if (recording_) until = std::min(until, recording_->untilNext());
    if (playback_) until = std::min(until, playback_->untilNext());
    return until;
}

bool ServerState::atRest() const { return player_->atRest() && !playback_; }

// --- Recording ---

void ServerState::refuseSecondRecording() const {
    if (recording_) {
        throw std::runtime_error("a recording is under way: " + recording_->list().string() +
                                 "; 'export video stop' ends it");
    }
}

void ServerState::startRecording(std::unique_ptr<Recording> recording) {
    refuseSecondRecording();
    recordingFailure_.clear();
    recording_ = std::move(recording);
    recordedList_ = recording_->list();
}

int ServerState::stopRecording(float exposure) {
    if (!recording_) {
        throw std::runtime_error("nothing is being recorded" +
                                 (recordingFailure_.empty() ? "" : "; " + recordingFailure_));
    }
    const std::unique_ptr<Recording> recording = std::move(recording_);
    recording->settle(exposure);
    recording->finish();
    return recording->frames();
}

void ServerState::settleRecording(float exposure) {
    if (!recording_) return;
    try {
        recording_->settle(exposure);
    } catch (const rtcore::FileError& error) {
        endRecording(error.what());
        throw;
    }
}

void ServerState::endRecording(const std::string& reason) {
    recordingFailure_ = fmt::format("the recording {} ended after {} frames: {}", recording_->list().string(),
                                    recording_->frames(), reason);
    recording_.reset();
}

void ServerState::takeRecordedView() {
    if (!recording_ || recording_->untilNext() > 0ns) return;
    takeCamera();
    recording_->add(cameraFileOf(*this, 1));
}

// --- Playing ---

void ServerState::play(std::unique_ptr<Playback> playback) {
    stopPlaying();
    if (walking()) player_->setMode(rtcore::MotionMode::View);
    playback_ = std::move(playback);
}

void ServerState::show(const Playback::Shot& shot) {
    rtcore::CameraFile camera = shot.camera;
    camera.time.reset();
    if (camera == shown_) return;
    rtcore::Scene edited = *scene_;
    const std::string warning = app::applyCameraToScene(camera, shot.path, edited);
    publish(std::move(edited));
    // Once: the other cameras of the path say the same.
    if (!warning.empty() && !shown_) Messages::print("warning: " + warning);
    player_->setCamera(camera.camera);
    takeCamera();
    if (camera.exposure != (shown_ ? shown_->exposure : std::nullopt))
        revisions_.note({rtcore::Change::Setting});
    shown_ = std::move(camera);
}

void ServerState::stopPlaying() {
    if (!playback_) return;
    playback_.reset();
    // The eye gets used to what it sees again.
    if (shown_ && shown_->exposure) revisions_.note({rtcore::Change::Setting});
    shown_.reset();
}

} // namespace rtserver

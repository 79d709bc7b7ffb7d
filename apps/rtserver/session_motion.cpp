// What moves by itself: the player, keys that are pressed for a time, a path that is recorded or played.
#include "rtserver/exports.h"
#include "rtserver/session.h"

#include "common/settings_merge.h"

#include "rtcore/motion/player.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace rtserver {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

namespace {
constexpr nanoseconds kLongestTurn = 250ms; ///< after a stall nobody leaps
} // namespace

void Session::move(nanoseconds time, const ipc::KeyState& clientKeys) {
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

void Session::advance(nanoseconds step) {
    player_->advance(step);
    if (keyboard_.advance(step)) hold();
    if (recording_) recording_->advance(step);
    if (!playback_) return;
    if (const std::optional<Playback::Shot> shot = playback_->advance(step)) show(*shot);
    if (playback_ && playback_->ended()) stopPlaying();
}

void Session::press(const ipc::KeyState& clientKeys) {
    clientKeys_ = clientKeys.down;
    ipc::KeyState keys = clientKeys;
    keyboard_.collect(keys);
    const auto before = std::exchange(lastDown_, keys.down);
    for (const rtcore::ActionTap& tap : bindings_.taps(keys.down, keys.presses, before)) apply(tap);
    hold();
}

void Session::hold() {
    const rtcore::ActionSet actions = bindings_.held(clientKeys_ | keyboard_.down());
    if (!actions.none()) stopPlaying(); // who moves takes over
    player_->hold(actions);
}

// What the scene does not have is no error of who presses a key.
void Session::apply(const rtcore::ActionTap& tap) {
    const rtcore::Scene& scene = world_->loaded.scene;
    const int index = tap.number - 1;
    const auto among = [&](std::size_t count) {
        return index >= 0 && static_cast<std::size_t>(index) < count;
    };
    if (rtcore::isHeld(tap.action)) {
        stopPlaying();
        player_->tap(tap.action);
    } else if (tap.action == rtcore::Action::ToggleWalk) {
        stopPlaying();
        player_->setMode(walking() ? rtcore::MotionMode::View : rtcore::MotionMode::Walk);
    } else if (tap.action == rtcore::Action::ToggleBloom) {
        switchBloom(settings_.bloom == 0);
    } else if (tap.action == rtcore::Action::ToggleLight && among(scene.lights.size())) {
        switchLight(index, std::nullopt);
    } else if (tap.action == rtcore::Action::SelectEnvironment && among(scene.environments.size())) {
        setEnvironment(index);
    }
}

nanoseconds Session::untilEvent() const {
    nanoseconds until = keyboard_.untilRelease();
    if (recording_) until = std::min(until, recording_->untilNext());
    if (playback_) until = std::min(until, playback_->untilNext());
    return until;
}

bool Session::atRest() const { return player_->atRest() && !playback_; }

// --- Recording ---

void Session::startRecording(const std::filesystem::path& list, double framesPerSecond) {
    if (recording_) {
        throw std::runtime_error("a recording is under way: " + recording_->list().string() +
                                 "; 'export video stop' ends it");
    }
    recording_ = std::make_unique<Recording>(list, framesPerSecond);
}

int Session::stopRecording(float exposure) {
    if (!recording_) throw std::runtime_error("nothing is being recorded");
    const std::unique_ptr<Recording> recording = std::move(recording_);
    recording->settle(exposure);
    recording->finish();
    return recording->frames();
}

void Session::settleRecording(float exposure) {
    if (!recording_) return;
    try {
        recording_->settle(exposure);
    } catch (const rtcore::FileError&) {
        recording_.reset();
        throw;
    }
}

void Session::takeRecordedView() {
    if (!recording_ || recording_->untilNext() > 0ns) return;
    takeCamera();
    recording_->add(cameraFileOf(*this, 1));
}

// --- Playing ---

void Session::play(const std::filesystem::path& list) {
    auto playback = std::make_unique<Playback>(list);
    stopPlaying();
    if (walking()) player_->setMode(rtcore::MotionMode::View);
    playback_ = std::move(playback);
}

void Session::show(const Playback::Shot& shot) {
    rtcore::Scene& scene = world_->loaded.scene;
    rtcore::CameraFile camera = shot.camera;
    camera.time.reset();
    if (camera == shown_) return;
    app::applyCameraToScene(camera, shot.path, scene);
    player_->setCamera(camera.camera);
    camera_ = player_->camera();
    shown_ = std::move(camera);
    touch();
}

void Session::stopPlaying() {
    if (!playback_) return;
    playback_.reset();
    if (shown_ && shown_->exposure) touch(); // the eye gets used to what it sees again
    shown_.reset();
}

} // namespace rtserver

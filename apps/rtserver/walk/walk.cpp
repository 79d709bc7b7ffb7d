#include "rtserver/walk/walk.h"

#include "rtserver/document/exports.h"

#include "common/commands/key_restraint.h"
#include "common/commands/told_forms.h"
#include "common/settings/settings_merge.h"

#include "rtcore/look/doorstep.h"
#include "rtcore/motion/walk_shape.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

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

rtcore::Sentence tooSmallToWalk(const rtcore::Survey& found, float metresPerUnit) {
    const float height = rtcore::extentAlong(found.subject.bounds, found.axes.up) * metresPerUnit;
    return rtcore::say("the model is too small to walk: it is {0} m high; 'units' says how large it is",
                       fmt::format("{:.2g}", height));
}

/// But for which of them are on.
bool sameLights(const rtcore::Scene& a, const rtcore::Scene& b) {
    const auto alike = [](rtcore::Light one, const rtcore::Light& other) {
        one.on = other.on;
        return one == other;
    };
    return std::ranges::equal(a.lights, b.lights, alike, &rtcore::SceneLight::light,
                              &rtcore::SceneLight::light);
}

} // namespace

Walk::Walk(Document& document, Messages& messages, std::optional<std::filesystem::path> path)
    : document_(document), messages_(messages), firstPath_(std::move(path)) {
    document_.setFollower(this);
}

Walk::~Walk() { document_.setFollower(nullptr); }

// --- The document was edited ---

void Walk::sceneOpened() {
    stopPlaying();
    if (recording_) endRecording(rtcore::say("another scene was shown"));
    pivot_.reset();
    makePlayer();
    if (!firstPath_) return;
    const std::filesystem::path path = *std::exchange(firstPath_, std::nullopt);
    play(std::make_unique<Playback>(path, document_.scene()->origin));
}

// Cameras of a recording say which lights are on, not what they are like: a film of it would show other
// light. What carries a walker, and where it falls, is found anew where other parts are visible.
void Walk::sceneEdited(const rtcore::Scene& before, const rtcore::Changes& changes) {
    if (recording_ && !sameLights(before, *document_.scene())) {
        endRecording(rtcore::say("the lights were edited"));
        messages_.warn(*recordingFailure_);
    }
    const rtcore::Scene& now = *document_.scene();
    const bool cut = before.sections.planes != now.sections.planes || before.uncutParts != now.uncutParts;
    if (!changes.has(rtcore::Change::Visibility) && !cut) return;
    treeReplaced();
    useSections();
    if (!walking()) return;
    player_->setMode(rtcore::MotionMode::View);
    player_->setMode(rtcore::MotionMode::Walk);
    takeCamera();
}

void Walk::useSections() {
    const rtcore::Scene& scene = *document_.scene();
    const bool some = scene.uncutParts != nullptr;
    player_->useSections(scene.sections.planes,
                         some ? partTriangles(scene.model, scene.uncutParts) : std::vector<std::uint8_t>());
}

void Walk::treeReplaced() { player_->useTree(document_.visible().tree()); }

// A recording and a walk belong to the old up axis and unit, and end. Flying goes on.
void Walk::unitsChanged() {
    stopPlaying();
    if (recording_) endRecording("the up axis or the unit was changed");
    const double speed = player_->speedFactor();
    makePlayer();
    player_->setSpeedFactor(speed);
}

// A body comes along, and may need another place to stand.
void Walk::cameraPlaced() {
    stopPlaying();
    player_->setCamera(document_.camera());
    takeCamera();
}

void Walk::makePlayer() {
    const rtcore::Scene& scene = *document_.scene();
    player_ = std::make_unique<rtcore::Player>(
        document_.visible().tree(), document_.world().loaded.scene.model.mesh,
        rtcore::PlayerOptions{
            .up = scene.up, .metresPerUnit = double{scene.metresPerUnit}, .walk = scene.walk});
    useSections();
    player_->setCamera(document_.camera());
}

// --- Time and keys ---

void Walk::move(nanoseconds time, const ipc::KeyState& clientKeys, const EditByKey& edit) {
    nanoseconds left = std::clamp<nanoseconds>(time, 0ns, kLongestTurn);
    while (true) {
        takeRecordedView();
        if (left == 0ns) break;
        const nanoseconds step = std::clamp<nanoseconds>(untilEvent(), 1ns, left);
        advance(step);
        left -= step;
    }
    press(clientKeys, edit);
    takeCamera();
}

void Walk::advance(nanoseconds step) {
    player_->advance(step);
    if (keyboard_.advance(step)) hold();
    if (recording_) recording_->advance(step);
    if (!playback_) return;
    if (const std::optional<Playback::Shot> shot = playback_->advance(step)) show(*shot);
    if (playback_ && playback_->ended()) stopPlaying();
}

void Walk::press(const ipc::KeyState& clientKeys, const EditByKey& edit) {
    clientKeys_ = clientKeys.down;
    ipc::KeyState keys = clientKeys;
    keyboard_.collect(keys);
    const auto before = std::exchange(lastDown_, keys.down);
    const auto withheld = [&](const rtcore::KeyBinding& binding) -> std::uint32_t {
        const auto level = static_cast<std::size_t>(app::withheldFrom(binding.action));
        return level == 0 ? 0 : clientKeys.restrained[level - 1][static_cast<std::size_t>(binding.key)];
    };
    for (const rtcore::ActionTap& tap : bindings_.taps(keys.down, keys.presses, before, withheld))
        apply(tap, edit);
    hold();
}

void Walk::hold() {
    const rtcore::ActionSet actions = bindings_.held(clientKeys_ | keyboard_.down());
    if (!actions.none()) stopPlaying(); // a movement ends the playback
    player_->hold(actions);
}

void Walk::apply(const rtcore::ActionTap& tap, const EditByKey& edit) {
    if (rtcore::isHeld(tap.action)) {
        stopPlaying();
        player_->tap(tap.action);
    } else if (tap.action == rtcore::Action::ToggleWalk) {
        toggleWalking();
    } else {
        edit(tap);
    }
}

void Walk::toggleWalking() {
    try {
        setWalking(!walking());
        messages_.tell(onUnseenFloor() ? app::told::kUnseenFloor
                       : walking()     ? app::told::kWalking
                                       : app::told::kFlying);
    } catch (const std::runtime_error& error) {
        messages_.tell(rtcore::sentenceOf(error));
    }
}

nanoseconds Walk::untilEvent() const {
    nanoseconds until = keyboard_.untilRelease();
    if (recording_) until = std::min(until, recording_->untilNext());
    if (playback_) until = std::min(until, playback_->untilNext());
    return until;
}

// --- Where one is ---

void Walk::turn(double right, double upwards) {
    constexpr double kRadians = std::numbers::pi / 180;
    stopPlaying();
    player_->look(right * kRadians, upwards * kRadians);
    takeCamera();
}

void Walk::setWalking(bool walking) {
    stopPlaying();
    if (walking && !this->walking()) beginWalking();
    if (!walking) player_->setMode(rtcore::MotionMode::View);
    takeCamera();
}

// One who looks from above or from afar begins before the model, and faces it.
void Walk::beginWalking() {
    const rtcore::Scene& scene = *document_.scene();
    const rtcore::Mesh& mesh = scene.model.mesh;
    const rtcore::KdTree& tree = document_.visible().tree();
    const rtcore::Survey found = rtcore::survey(tree, mesh, axesOfPlayer(scene));
    if (rtcore::isTooSmallToWalk(found)) throw rtcore::Refusal(tooSmallToWalk(found, scene.metresPerUnit));
    const rtcore::Camera before = player_->camera();
    if (rtcore::hoversOutside(tree, mesh, found, before.eye)) {
        for (const rtcore::Camera& camera : rtcore::doorsteps(tree, mesh, found, before)) {
            player_->setCamera(camera);
            if (player_->setMode(rtcore::MotionMode::Walk)) return;
        }
        player_->setCamera(before);
    }
    if (!player_->setMode(rtcore::MotionMode::Walk)) throw rtcore::Refusal(app::told::kNoRoom);
}

void Walk::resetCamera() {
    const bool walked = walking();
    player_->setMode(rtcore::MotionMode::View);
    document_.setCamera(document_.world().loaded.camera);
    const rtcore::Scene& scene = *document_.scene();
    const rtcore::KdTree& tree = document_.visible().tree();
    const rtcore::Survey found = rtcore::survey(tree, scene.model.mesh, axesOfPlayer(scene));
    if (walked && !rtcore::hoversOutside(tree, scene.model.mesh, found, document_.camera().eye))
        player_->setMode(rtcore::MotionMode::Walk);
    takeCamera();
}

rtcore::Vec3 Walk::pivot() {
    if (pivot_) return *pivot_;
    const rtcore::Scene& scene = *document_.scene();
    const rtcore::Box3 bounds = rtcore::subjectOf(scene.model.mesh, rtcore::axesOf(scene)).bounds;
    pivot_ = bounds.empty() ? rtcore::Vec3{} : bounds.centre();
    return *pivot_;
}

// --- Recording ---

void Walk::refuseSecondRecording() const {
    if (recording_) {
        throw rtcore::Refusal(rtcore::say("a recording is under way: {0}; 'export video stop' ends it",
                                          recording_->list().string()));
    }
}

void Walk::startRecording(std::unique_ptr<Recording> recording) {
    refuseSecondRecording();
    recordingFailure_.reset();
    recording_ = std::move(recording);
    recordedList_ = recording_->list();
}

int Walk::stopRecording(float exposure) {
    if (!recording_) {
        const rtcore::Sentence none = rtcore::say("nothing is being recorded");
        throw rtcore::Refusal(recordingFailure_ ? rtcore::say("{0}; {1}", none, *recordingFailure_) : none);
    }
    const std::unique_ptr<Recording> recording = std::move(recording_);
    recording->settle(exposure);
    recording->finish();
    return recording->frames();
}

void Walk::settleRecording(float exposure) {
    if (!recording_) return;
    try {
        recording_->settle(exposure);
    } catch (const rtcore::FileError& error) {
        endRecording(rtcore::sentenceOf(error));
        throw;
    }
}

void Walk::endRecording(const rtcore::Sentence& reason) {
    recordingFailure_ = rtcore::say("the recording {0} ended after {1} frames: {2}",
                                    recording_->list().string(), recording_->frames(), reason);
    recording_.reset();
}

void Walk::takeRecordedView() {
    if (!recording_ || recording_->untilNext() > 0ns) return;
    takeCamera();
    recording_->add(cameraFileOf(document_, 1));
}

// --- Playing ---

void Walk::play(std::unique_ptr<Playback> playback) {
    stopPlaying();
    if (walking()) player_->setMode(rtcore::MotionMode::View);
    playback_ = std::move(playback);
}

void Walk::show(const Playback::Shot& shot) {
    rtcore::CameraFile camera = shot.camera;
    camera.time.reset();
    if (camera == playedView_) return;
    rtcore::Scene edited = *document_.scene();
    const rtcore::Sentence warning = app::applyCameraToScene(camera, shot.path, edited);
    document_.publish(std::move(edited));
    // Once: the other cameras of the path say the same.
    if (!warning.empty() && !playedView_) Messages::print(rtcore::say("warning: {0}", warning));
    player_->setCamera(camera.camera);
    takeCamera();
    document_.setPlayedExposure(camera.exposure);
    playedView_ = std::move(camera);
}

// The eye gets used to what it sees again.
void Walk::stopPlaying() {
    if (!playback_) return;
    playback_.reset();
    playedView_.reset();
    document_.setPlayedExposure(std::nullopt);
}

} // namespace rtserver

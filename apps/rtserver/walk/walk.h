/// How one moves in a document: by keys, by the clock, along a path that is played - and the path that is
/// recorded meanwhile.
#pragma once

#include "rtserver/document/document.h"
#include "rtserver/document/document_follower.h"
#include "rtserver/messages.h"
#include "rtserver/walk/keyboard.h"
#include "rtserver/walk/playback.h"
#include "rtserver/walk/recording.h"

#include "rtcore/motion/key_bindings.h"
#include "rtcore/motion/player.h"
#include "rtcore/platform/sentence.h"

#include <bitset>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace rtserver {

/// Tells the document where the camera is, and follows where edits place it. What keys edit it leaves to
/// others. Moving needs a document that is ready. For the thread that edits the document; others may read
/// while that does not.
class Walk final : private DocumentFollower {
  public:
    /// Both must outlive it. `path` is played in the first scene; `messages` are told what keys did, and why
    /// a recording ended.
    Walk(Document& document, Messages& messages, std::optional<std::filesystem::path> path);
    ~Walk() override;
    Walk(const Walk&) = delete;
    Walk& operator=(const Walk&) = delete;

    /// Does what a key says that edits the document.
    using EditByKey = std::function<void(const rtcore::ActionTap&)>;
    /// Lets what was pressed act for the time since the last call, and then hands in what is pressed now.
    /// Throws FileError when the path that is played cannot be read.
    void move(std::chrono::nanoseconds time, const ipc::KeyState& clientKeys, const EditByKey& edit);
    /// Nothing moves until something is pressed.
    bool atRest() const { return player_->atRest() && !playback_; }
    /// How long move() may wait for its next call while no key is pressed.
    std::chrono::nanoseconds untilEvent() const;
    Keyboard& keyboard() { return keyboard_; }
    const rtcore::KeyBindings& bindings() const { return bindings_; }
    void setBindings(rtcore::KeyBindings bindings) { bindings_ = std::move(bindings); }

    /// To the right and upwards, degrees.
    void turn(double right, double upwards);
    bool walking() const { return player_->mode() == rtcore::MotionMode::Walk; }
    /// Throws std::runtime_error where there is no room for a body, or no floor below.
    void setWalking(bool walking);
    /// Beside the model, where only a floor that is not seen carries.
    bool onUnseenFloor() const { return player_->onUnseenFloor(); }
    /// The speed of flying, in multiples of the scene's usual one; until another scene is shown.
    void setSpeed(double factor) { player_->setSpeedFactor(factor); }
    /// The scene's view, walking or not.
    void resetCamera();
    /// The centre of orbits and zooms: the point that was chosen, else the middle of the model's subject.
    rtcore::Vec3 pivot();
    void setPivot(std::optional<rtcore::Vec3> pivot) { pivot_ = pivot; }

    /// Records the camera in the time that move() is told of. Throws std::runtime_error when a recording is
    /// under way.
    void startRecording(std::unique_ptr<Recording> recording);
    void refuseSecondRecording() const;
    /// The number of cameras. Throws std::runtime_error when there is no recording, with the reason why the
    /// last one ended by itself, and FileError.
    int stopRecording(float exposure);
    bool recording() const { return recording_ != nullptr; }
    /// How much time is recorded; 0 when nothing is being recorded.
    std::chrono::nanoseconds recordedTime() const {
        return recording_ ? recording_->time() : std::chrono::nanoseconds(0);
    }
    /// The list of the last startRecording(), absolute; empty before it.
    const std::filesystem::path& recordedList() const { return recordedList_; }
    /// The exposure of the frame that is shown: what was recorded since the last call is written. Throws
    /// FileError, with the recording ended.
    void settleRecording(float exposure);

    /// Shows a recorded path, from its first camera on; the frames keep their size and quality. Ends with its
    /// last camera, when a key moves the camera, or when an edit places it.
    void play(std::unique_ptr<Playback> playback);
    void stopPlaying();

  private:
    void sceneOpened() override;
    void sceneEdited(const rtcore::Scene& before, const rtcore::Changes& changes) override;
    void treeReplaced() override;
    void unitsChanged() override;
    void cameraPlaced() override;

    void useSections();
    void makePlayer();
    void takeCamera() { document_.moveCamera(player_->camera()); }
    void beginWalking();

    void advance(std::chrono::nanoseconds step);
    void press(const ipc::KeyState& clientKeys, const EditByKey& edit);
    void hold();
    void apply(const rtcore::ActionTap& tap, const EditByKey& edit);
    void toggleWalking();
    void takeRecordedView();
    void endRecording(const rtcore::Sentence& reason);
    void show(const Playback::Shot& shot);

    Document& document_;
    Messages& messages_;
    std::optional<std::filesystem::path> firstPath_; ///< to be played when a scene is there
    std::unique_ptr<rtcore::Player> player_;         ///< refers to the document's model and its visible tree
    std::optional<rtcore::Vec3> pivot_;
    rtcore::KeyBindings bindings_;
    Keyboard keyboard_;
    std::bitset<ipc::kMaxKeys> clientKeys_;
    std::bitset<ipc::kMaxKeys> lastDown_; ///< and those of commands, at the last look
    std::unique_ptr<Recording> recording_;
    std::optional<rtcore::Sentence> recordingFailure_; ///< why the last one ended by itself
    std::filesystem::path recordedList_;
    std::unique_ptr<Playback> playback_;
    std::optional<rtcore::CameraFile> playedView_; ///< of the path that is played, without its time
};

} // namespace rtserver

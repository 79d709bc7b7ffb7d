/// The state that the server shows: scene, camera, settings, lights. Knows nothing of clients and frames.
#pragma once

#include "rtserver/edit_history.h"
#include "rtserver/keyboard.h"
#include "rtserver/messages.h"
#include "rtserver/pack_progress.h"
#include "rtserver/playback.h"
#include "rtserver/recording.h"
#include "rtserver/server_options.h"
#include "rtserver/world.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/motion/key_bindings.h"
#include "rtcore/scene/revisions.h"
#include "rtcore/settings/render_settings.h"

#include <bitset>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rtcore {
class Player;
}

namespace rtserver {

/// Of ServerState::onUnseenFloor().
inline constexpr const char* kUnseenFloor =
    "nothing is below: walking on a floor at the model's lowest point that is not seen";

/// Every edit of what is shown is noted by its kind in revisions(), by which frames and caches tell whether
/// they still hold. What changes nothing is not noted.
///
/// One thread edits; others may read while it does not, such as the guard's while a frame is drawn. The scene
/// is immutable: an edit puts another one in its place, and a thread that took the last one keeps it.
class ServerState {
  public:
    using Reserve = std::function<void(const rtcore::RenderSettings&)>;
    /// `reserve` throws when frames of such settings cannot be made and published. `messages` are told what
    /// keys did. `options` and `messages` must outlive it.
    ServerState(const Options& options, Reserve reserve, Messages& messages);

    ~ServerState();

    /// Shows another scene: its camera and its settings, but the frames keep their size. The first one gets
    /// what the command line says of camera, settings and size. Throws FileError, with the old scene still
    /// there.
    void show(std::unique_ptr<World> world);
    bool ready() const { return world_ != nullptr; }
    /// What follows but revisions() needs ready().
    const World& world() const { return *world_; }
    /// As it is shown, with its lights and its environment. To be copied where it has to last: the next edit
    /// puts another one here.
    const std::shared_ptr<const rtcore::Scene>& scene() const { return scene_; }
    /// Of all that is shown: scene, camera, settings.
    const rtcore::Revisions& revisions() const { return revisions_; }
    /// The exact tree of the same scene, with its tracer. The frames stay the same.
    void useTree(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer);
    /// What is visible is traced by the pruned tree of all, by which rays are slower than by one of its own.
    bool prunes() const { return prunes_; }
    /// One built of what is visible. The frames stay the same. Nothing where other parts are hidden by now.
    void useVisibleTree(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer,
                        const rtcore::HiddenParts& hidden);
    std::string title() const; ///< for messages
    /// Of what is shown: without hidden parts. A thread of its own that traces keeps it, together with a
    /// scene: that owns the triangles.
    const std::shared_ptr<const rtcore::RayTracer>& tracer() const { return tracer_; }

    const rtcore::Camera& camera() const { return camera_; }
    /// Throws std::invalid_argument for one that cannot be looked through.
    void setCamera(const rtcore::Camera& camera);
    /// To the right and upwards, degrees.
    void turn(double right, double upwards);
    /// Throws std::runtime_error where there is no room for a body, or no floor below.
    void setWalking(bool walking);
    /// The scene's view, walking or not.
    void resetCamera();
    /// What orbits and zooms are about: the point that was chosen, else the middle of what the model is
    /// about.
    rtcore::Vec3 pivot();
    void setPivot(std::optional<rtcore::Vec3> pivot) { pivot_ = pivot; }
    /// Beside the model, where only a floor that is not seen carries.
    bool onUnseenFloor() const;
    /// Of flying, in times the usual speed of the scene; until another scene is shown.
    void setSpeed(double factor);
    bool walking() const;

    const rtcore::RenderSettings& settings() const { return settings_; }
    /// Throws what `reserve` and rtcore::checkLive() throw, with nothing changed.
    void setSettings(const rtcore::RenderSettings& settings);
    /// Those of a frame that was published: there is room for it.
    void goBackTo(const rtcore::RenderSettings& settings);
    /// The settings, with the exposure of the path that is being played.
    rtcore::RenderSettings shownSettings() const;
    void switchBloom(bool on); ///< as strong as it was

    /// Looks through a .cam and takes over what else it says; `path` is for messages. Returns a warning of
    /// what does not suit the scene, or "". Throws FileError, with nothing changed.
    std::string applyCameraFile(const rtcore::CameraFile& file, const std::filesystem::path& path);
    /// Settings of a file that was checked.
    void assign(const std::vector<rtcore::SettingAssignment>& assignments);
    // Lights by their ids. They throw std::invalid_argument when the scene has no such light.
    std::size_t lightOf(int id) const;                ///< its place among the scene's lights
    void switchLight(int id, std::optional<bool> on); ///< nothing: the other way round
    /// `change` gets the light to be changed, but for its id; what it throws leaves the light as it is.
    void changeLight(int id, const std::function<void(rtcore::LightDescription&)>& change);
    /// It gets an id of its own, which is returned.
    int addLight(rtcore::LightDescription light);
    void removeLight(int id);
    /// Counted from 0. Throws std::invalid_argument when the scene has fewer.
    void setEnvironment(int environment);
    /// Materials of the model, counted from 0; all must be there. What surfaces are closed follows.
    void editMaterials(std::span<const std::size_t> materials, const rtcore::MaterialOverride& change);
    void resetMaterials(std::span<const std::size_t> materials); ///< as the files have them
    /// Parts of this model. Rays and bodies pass through what is hidden.
    void hideParts(rtcore::HiddenParts hidden);
    /// Nothing: none, and what a model without lights is given is switched on again. A first one, and a map,
    /// light the scene from then on (skyLight.on).
    void setSky(const std::optional<rtcore::Sky>& sky);
    /// In place of all lights, of the sky and of the environment; skyLight.on follows.
    void setLook(rtcore::Look look);
    /// Shown from then on, in place of a sky.
    void addEnvironment(const rtcore::EnvironmentFile& file, rtcore::Environment environment);
    void leaveEnvironment(); ///< neither sky nor map
    /// Of the one that is shown. They throw std::runtime_error where there is none, or nothing to turn.
    void rotateEnvironment(float degrees);
    void scaleEnvironment(float factor);

    /// The scene's own, as its file is to have them.
    const rtcore::SceneBookmarks& bookmarks() const { return *bookmarks_; }
    void setBookmarks(rtcore::SceneBookmarks bookmarks);

    /// What edits change.
    Shown shown() const { return {scene_, settings_, camera_, frame(), bookmarks_}; }
    /// What changed since shown() was `before` is one step that can be taken back. `label` and `goesOn`: as
    /// in EditHistory.
    void keepStep(std::string label, Shown before, const EditAuthor& by = {}, bool goesOn = false);
    /// The last step taken back, or made again, or that of a number alone; they return its label. Throw
    /// std::runtime_error where there is none, and what setSettings() throws.
    std::string undo(std::optional<int> number = {});
    std::string redo(std::optional<int> number = {});
    const EditHistory& history() const { return history_; }
    /// Edits were made, or taken back, that the scene's file does not have. Where the camera stands is none.
    bool modified() const { return history_.state() != savedState_; }
    /// `path`, absolute, holds what was shown when history() was in that state. It is the scene's file from
    /// now on - unless another scene was shown since.
    void noteSaved(const std::filesystem::path& path, std::uint64_t historyState);

    /// Lets what was pressed act for the time since the last call, and then hands in what is pressed now.
    /// Throws FileError when the path that is played cannot be read.
    void move(std::chrono::nanoseconds time, const ipc::KeyState& clientKeys);
    /// Nothing moves until something is pressed.
    bool atRest() const;
    /// How long move() may wait for its next call while no key is pressed.
    std::chrono::nanoseconds untilEvent() const;
    Keyboard& keyboard() { return keyboard_; }
    const rtcore::KeyBindings& bindings() const { return bindings_; }
    void setBindings(rtcore::KeyBindings bindings) { bindings_ = std::move(bindings); }
    float metresPerUnit() const;
    /// The scene's up axis and unit, and who says them.
    const rtcore::UpAndUnit& frame() const;
    /// Another up axis, another unit, as the user says. The model stays where it is: the view of a model
    /// without a camera is found again, flying goes on.
    void setFrame(std::optional<rtcore::Vec3> up, std::optional<double> metresPerUnit);
    /// What would be guessed of a model by itself.
    void guessFrame(bool up, bool unit);

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
    /// last camera, or when a key moves the camera.
    void play(std::unique_ptr<Playback> playback);
    void stopPlaying();

    bool paused = false;
    std::shared_ptr<PackProgress> packing; ///< of the pack that is being made; null: none is
    double frameSeconds = 0; ///< what a frame may take while something moves: fewer pixels then; 0: any time
    bool idles = true;       ///< false: every frame is drawn, though it equals the last

  private:
    rtcore::RenderSettings settingsOf(const World& world, const rtcore::CameraFile* camera) const;
    void publish(rtcore::Scene edited);
    void makeTree();
    void useVisible();
    void endOutdatedRecording(const rtcore::Scene& edited);
    void makePlayer(const rtcore::Camera& camera);
    void useFrame(const rtcore::UpAndUnit& frame);
    void takeSettings(const rtcore::RenderSettings& settings);
    void makeOf(const EditStep& step, const Shown& from, const Shown& to);
    void beginWalking();
    void takeCamera();
    void putScene(rtcore::Scene edited);
    void lightBySky();
    void switchHeadlight(rtcore::Scene& scene, bool on) const;

    void advance(std::chrono::nanoseconds step);
    void press(const ipc::KeyState& clientKeys);
    void hold();
    void apply(const rtcore::ActionTap& tap);
    void toggleWalking();
    void toggleLight(int id);
    void chooseEnvironment(int environment);
    void takeRecordedView();
    void endRecording(const std::string& reason);
    void show(const Playback::Shot& shot);

    const Options& options_;
    Reserve reserve_;
    Messages& messages_;
    std::unique_ptr<World> world_;
    std::shared_ptr<const rtcore::Scene> scene_;
    rtcore::KdTree tree_;                                 ///< of what is shown
    bool prunes_ = false;                                 ///< that is a pruned one
    std::shared_ptr<const rtcore::KdRayTracer> surfaces_; ///< by that tree
    std::shared_ptr<const rtcore::RayTracer> tracer_;     ///< of them and of the ground
    rtcore::Revisions revisions_;
    std::unique_ptr<rtcore::Player> player_; ///< refers to *world_ and tree_
    std::optional<rtcore::Vec3> pivot_;
    rtcore::Camera camera_;
    rtcore::KeyBindings bindings_;
    rtcore::RenderSettings settings_;
    std::shared_ptr<const rtcore::SceneBookmarks> bookmarks_;
    EditHistory history_;
    std::uint64_t savedState_ = 0;
    int bloom_; ///< its radius when it is switched on
    Keyboard keyboard_;
    std::bitset<ipc::kMaxKeys> clientKeys_;
    std::bitset<ipc::kMaxKeys> lastDown_; ///< and those of commands, at the last look
    std::unique_ptr<Recording> recording_;
    std::string recordingFailure_; ///< why the last one ended by itself; "" = it did not
    std::filesystem::path recordedList_;
    std::unique_ptr<Playback> playback_;
    std::optional<rtcore::CameraFile> shown_; ///< of the path that is played, without its time
};

} // namespace rtserver

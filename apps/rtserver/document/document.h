/// The document: what is shown, and the edits of it. Knows nothing of the walk in it, of clients and of
/// frames.
#pragma once

#include "rtserver/document/document_follower.h"
#include "rtserver/document/edit_history.h"
#include "rtserver/document/variant_book.h"
#include "rtserver/document/visible_model.h"
#include "rtserver/document/world.h"
#include "rtserver/messages.h"
#include "rtserver/server_options.h"

#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/scene/revisions.h"
#include "rtcore/sections/cap_painter.h"
#include "rtcore/settings/render_settings.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rtserver {

/// Every edit of what is shown is noted by its kind in revisions(), by which frames and caches tell whether
/// they still hold. What changes nothing is not noted. Edits of lights, surroundings, materials and parts
/// are functions of a document: light_list.h, sky_edits.h, model_edits.h.
///
/// One thread edits; others may read while it does not, such as the guard's while a frame is drawn. The scene
/// is immutable: an edit puts another one in its place, and a thread that took the last one keeps it.
class Document {
  public:
    using Reserve = std::function<void(const rtcore::RenderSettings&)>;
    /// `reserve` throws when frames of such settings cannot be made and published. `messages` lose their
    /// offers when the user decides. `options` and `messages` must outlive it.
    Document(const Options& options, Reserve reserve, Messages& messages);
    /// Is told of edits at once; null: none is.
    void setFollower(DocumentFollower* follower) { follower_ = follower; }

    /// Shows another scene: its camera and its settings, but the frames keep their size. The first one gets
    /// what the command line says of camera, settings and size. Throws FileError, with the old scene still
    /// there.
    void show(std::unique_ptr<World> world);
    bool ready() const { return world_ != nullptr; }
    /// All below but revisions() needs ready().
    const World& world() const { return *world_; }
    std::string title() const; ///< for messages
    /// As it is shown, with its lights and its environment. To be copied where it has to last: the next edit
    /// puts another one here.
    const std::shared_ptr<const rtcore::Scene>& scene() const { return scene_; }
    /// The same for images: where false colours are on, with all of its light in one unit
    /// (rtcore::inUnitOfSky()).
    const std::shared_ptr<const rtcore::Scene>& imagedScene() const { return imaged_; }
    /// The revisions of all that is shown: scene, camera, settings.
    const rtcore::Revisions& revisions() const { return revisions_; }

    // --- What is traced ---

    const VisibleModel& visible() const { return visible_; }
    /// The tracer of what is shown: without hidden parts.
    const std::shared_ptr<const rtcore::RayTracer>& tracer() const { return visible_.tracer(); }
    /// The exact tree of the same scene, with its tracer. The frames stay the same.
    void useTree(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer);
    /// One built of what is visible. The frames stay the same. Nothing where other parts are hidden by now.
    void useVisibleTree(rtcore::KdTree tree, std::shared_ptr<const rtcore::KdRayTracer> tracer,
                        const rtcore::HiddenParts& hidden);

    /// One built of what is left of that within `halves`. The frames stay the same. Nothing where other parts
    /// are hidden by now, or sections leave something else.
    void useTreeWithin(const rtcore::KdRayTracer& built, const rtcore::HiddenParts& hidden,
                       std::span<const rtcore::HalfSpace> halves);

    /// What closes the solids that sections cut; safe from several threads.
    rtcore::CapPainter& caps() const { return *caps_; }

    // --- Scene ---

    /// `edited`, a copy of the scene that was changed, is shown in its place. Its model is the same.
    void publish(rtcore::Scene edited);
    /// A file that an edit reads is one of what is shown: it is not written over.
    void addInput(const std::filesystem::path& path) { world_->inputs.add(path); }
    /// The up axis and the unit of the model, and who says them.
    const rtcore::ModelUnits& modelUnits() const { return world_->loaded.units; }
    /// Another up axis, another unit, as the user says. The model stays where it is: the view of a model
    /// without a camera is found again.
    void setModelUnits(std::optional<rtcore::Vec3> up, std::optional<double> metresPerUnit);
    /// Takes the guess for a model by itself: of its up axis, its unit, or both.
    void guessModelUnits(bool up, bool unit);

    // --- Camera ---

    const rtcore::Camera& camera() const { return camera_; }
    /// An edit. Throws std::invalid_argument for one that cannot be looked through.
    void setCamera(const rtcore::Camera& camera);
    /// No edit: where the walk has come to.
    void moveCamera(const rtcore::Camera& camera);
    /// Looks through a .cam and takes over what else it says; `path` is for messages. Returns a warning of
    /// what does not suit the scene, or an empty one. Throws FileError, with nothing changed.
    rtcore::Sentence applyCameraFile(const rtcore::CameraFile& file, const std::filesystem::path& path);
    /// The scene's own, as its file is to have them.
    const rtcore::KeptMeasures& measures() const { return *measures_; }
    void setMeasures(rtcore::KeptMeasures measures);
    const rtcore::SceneNotes& notes() const { return *notes_; }
    void setNotes(rtcore::SceneNotes notes);
    /// Adds a note to those that are there now and to those of all steps: no step takes it back. Throws
    /// rtcore::Refusal where there are kMaxNotes now, or before or behind a step, with nothing changed.
    void addToAllNotes(const rtcore::SceneNote& note);
    const rtcore::Flights& flights() const { return *flights_; }
    void setFlights(rtcore::Flights flights);
    /// With the base that they are variants of; none of them is active where that is shown.
    const VariantBook& variants() const { return *variants_; }
    void setVariants(VariantBook variants);
    const rtcore::SceneBookmarks& bookmarks() const { return *bookmarks_; }
    void setBookmarks(rtcore::SceneBookmarks bookmarks);

    // --- Settings ---

    const rtcore::RenderSettings& settings() const { return settings_; }
    /// Throws what `reserve` and rtcore::checkLive() throw, with nothing changed.
    void setSettings(const rtcore::RenderSettings& settings);
    /// Those of a frame that was published: there is room for it.
    void goBackTo(const rtcore::RenderSettings& settings) { takeSettings(settings); }
    /// Settings of a file that was checked.
    void assign(const std::vector<rtcore::SettingAssignment>& assignments);
    void switchBloom(bool on); ///< as strong as it was
    /// No edit: while a path is played, what it says in place of the settings' exposure.
    void setPlayedExposure(std::optional<float> exposure);
    /// The settings, with that exposure.
    rtcore::RenderSettings frameSettings() const;

    // --- Steps ---

    /// The state that edits change, as it is now.
    Snapshot snapshot() const {
        return {scene_, settings_, camera_, modelUnits(), bookmarks_, measures_, notes_, flights_, variants_};
    }
    /// The changes since snapshot() was `before` become one step that can be taken back. `label` and
    /// `goesOn`: as in EditHistory.
    void keepStep(std::string label, Snapshot before, const EditAuthor& by = {}, bool goesOn = false);
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

  private:
    void putScene(rtcore::Scene edited);
    void imageScene();
    void useModelUnits(const rtcore::ModelUnits& units);
    void placeCamera(const rtcore::Camera& camera);
    void takeSettings(const rtcore::RenderSettings& settings);
    void makeOf(const EditStep& step, const Snapshot& from, const Snapshot& to);

    const Options& options_;
    Reserve reserve_;
    Messages& messages_;
    DocumentFollower* follower_ = nullptr;
    std::unique_ptr<World> world_;
    std::shared_ptr<const rtcore::Scene> scene_, imaged_;
    VisibleModel visible_;
    std::unique_ptr<rtcore::CapPainter> caps_ = std::make_unique<rtcore::CapPainter>();
    rtcore::Revisions revisions_;
    rtcore::Camera camera_;
    rtcore::RenderSettings settings_;
    std::optional<float> playedExposure_;
    int lastBloomRadius_; ///< when it is switched on again
    std::shared_ptr<const rtcore::SceneBookmarks> bookmarks_;
    std::shared_ptr<const rtcore::KeptMeasures> measures_;
    std::shared_ptr<const rtcore::SceneNotes> notes_;
    std::shared_ptr<const rtcore::Flights> flights_;
    std::shared_ptr<const VariantBook> variants_;
    EditHistory history_;
    std::uint64_t savedState_ = 0;
};

} // namespace rtserver

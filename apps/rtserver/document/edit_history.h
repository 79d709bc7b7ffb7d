/// The edits of what is shown, step by step, to be taken back and made again.
#pragma once

#include "rtserver/document/variant_book.h"

#include "rtcore/io/text/scn.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/scene.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/survey/model_units.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

namespace rtserver {

/// The state that edits change, at one moment. Cheap to keep: scenes are immutable and shared.
struct Snapshot {
    std::shared_ptr<const rtcore::Scene> scene; ///< of older steps without the sky's map: withSkyMap()
    rtcore::RenderSettings settings;
    rtcore::Camera camera;
    rtcore::ModelUnits modelUnits; ///< the up axis and the unit, and why
    std::shared_ptr<const rtcore::SceneBookmarks> bookmarks;
    std::shared_ptr<const rtcore::KeptMeasures> measures;
    std::shared_ptr<const rtcore::SceneNotes> notes;
    std::shared_ptr<const rtcore::Flights> flights;
    std::shared_ptr<const VariantBook> variants;
};

/// Who made an edit.
struct EditAuthor {
    std::uint64_t client = 0; ///< of ipc::Command; 0: a key
    int person = 0;           ///< whom that client serves, as it says; 0: it does not say
    friend bool operator==(const EditAuthor&, const EditAuthor&) = default;
};

struct EditStep {
    std::string label; ///< the command that does it, without its values: "set maxDepth", "light 2", "load
                       ///< camera altar"
    Snapshot before, after;
    EditAuthor by = {};
    std::uint64_t state = 0; ///< EditHistory::state() behind it
    int number = 0;          ///< none is given twice, over clear(), too
};

/// Whether a step changed the scene, the settings, the camera, the up axis or the unit, the bookmarks, the
/// measures, the notes: those that it left alone stay when it is taken back. A step that changed nothing is
/// none.
bool changesScene(const EditStep& step);
bool changesSettings(const EditStep& step);
bool changesCamera(const EditStep& step);
bool changesModelUnits(const EditStep& step);
bool changesBookmarks(const EditStep& step);
bool changesMeasures(const EditStep& step);
bool changesNotes(const EditStep& step);
bool changesFlights(const EditStep& step);
bool changesVariants(const EditStep& step);
/// It changed nothing but the camera.
bool placesOnlyTheCamera(const EditStep& step);

/// The last 5,000 steps, or as many as take 256 MB, but 100 in any case: a step that changes the scene takes
/// two times 132 bytes a material and about 300 a light. A new step takes the place of those that were taken
/// back. One thread.
class EditHistory {
  public:
    /// `goesOn`: it belongs to the last step, if that has the same label: one gesture of many edits. Not
    /// where another person made that.
    void add(EditStep step, bool goesOn);
    void clear();

    using Notes = std::shared_ptr<const rtcore::SceneNotes>;
    /// Whether `of` says so of the notes before or behind a step.
    bool hasNotes(const std::function<bool(const Notes&)>& of) const;
    /// Other notes before and behind each step, those taken back included, by a change that is no step. All
    /// states are others from then on, so that none is one that was saved.
    void replaceNotes(const std::function<Notes(const Notes&)>& by);

    /// The step that undo takes back, and the one that redo makes again; null: there is none.
    const EditStep* last() const { return done_ > 0 ? &steps_[done_ - 1] : nullptr; }
    const EditStep* next() const { return done_ < steps_.size() ? &steps_[done_] : nullptr; }
    /// That was done. There must be such a step.
    void moveBack() { --done_; }
    void moveForth() { ++done_; }

    /// How many steps are made and not taken back, since the last clear().
    std::uint64_t position() const { return forgotten_ + done_; }

    /// A number of what all steps together have made, but for where they placed the camera: the same number,
    /// the same state. None is given twice, and later ones are larger, over clear(), too.
    std::uint64_t state() const { return done_ > 0 ? steps_[done_ - 1].state : base_; }
    /// That of the last clear().
    std::uint64_t firstState() const { return first_; }

  private:
    bool continues(const EditStep& step) const;
    void joinToLast(Snapshot after);
    std::uint64_t stateBehind(const EditStep& step, std::uint64_t before);
    void forgetFirst();

    std::deque<EditStep> steps_;
    std::size_t done_ = 0; ///< steps from here on were taken back
    std::uint64_t forgotten_ = 0;
    std::uint64_t newest_ = 0;
    int numbers_ = 0;                    ///< that were given
    std::uint64_t base_ = 0, first_ = 0; ///< states before the first step that is kept, and at clear()
};

} // namespace rtserver

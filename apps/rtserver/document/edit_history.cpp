#include "rtserver/document/edit_history.h"

#include "rtcore/sky/scene_sky.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rtserver {

namespace {

constexpr std::size_t kMaxSteps = 5000, kFewestSteps = 100;
constexpr std::size_t kMaxBytes = 256U << 20U;
/// Maps of skies are 6 MB each: those of steps before the last are drawn again when they are needed.
constexpr std::size_t kStepsWithMaps = 1;

void dropSkyMaps(EditStep& step) {
    const bool same = !changesScene(step);
    step.before.scene = rtcore::withoutSkyMap(step.before.scene);
    step.after.scene = same ? step.before.scene : rtcore::withoutSkyMap(step.after.scene);
}

/// The bytes that a scene has to itself: the rest is shared.
std::size_t bytesOf(const rtcore::Scene& scene) {
    constexpr std::size_t kLight = sizeof(rtcore::SceneLight) + sizeof(std::string);
    return sizeof(scene) + scene.materials.size() * sizeof(rtcore::Material) + scene.lights.size() * kLight +
           scene.materialEdits.size() * sizeof(rtcore::MaterialOverride);
}

std::size_t bytesOf(const rtcore::KeptMeasures& measures) {
    std::size_t bytes = 0;
    for (const rtcore::KeptMeasure& each : measures.all)
        bytes += sizeof(each) + each.points.size() * sizeof(rtcore::Vec3d) + each.name.size();
    return bytes;
}

std::size_t bytesOf(const rtcore::SceneNotes& notes) {
    std::size_t bytes = 0;
    for (const rtcore::SceneNote& each : notes)
        bytes += sizeof(each) + each.text.size() + each.author.size() + each.written.size();
    return bytes;
}

std::size_t bytesOf(const rtcore::Flights& flights) {
    std::size_t bytes = 0;
    for (const rtcore::Flight& each : flights)
        bytes += sizeof(each) + each.name.size() + each.keys.size() * sizeof(rtcore::FlightKey);
    return bytes;
}

std::size_t bytesOf(const VariantBook& book) {
    std::size_t bytes = sizeof(book);
    for (const rtcore::SceneVariant& each : book.all)
        bytes += sizeof(each) + each.materials.size() * sizeof(rtcore::MaterialOverride) +
                 each.parts.size() * sizeof(rtcore::PartDescription) +
                 each.lights.size() * sizeof(rtcore::LightDescription);
    return bytes;
}

std::size_t bytesOf(const EditStep& step) {
    const std::size_t measures =
        changesMeasures(step) ? bytesOf(*step.before.measures) + bytesOf(*step.after.measures) : 0;
    const std::size_t notes =
        changesNotes(step) ? bytesOf(*step.before.notes) + bytesOf(*step.after.notes) : 0;
    const std::size_t flights =
        changesFlights(step) ? bytesOf(*step.before.flights) + bytesOf(*step.after.flights) : 0;
    const std::size_t variants =
        changesVariants(step) ? bytesOf(*step.before.variants) + bytesOf(*step.after.variants) : 0;
    return sizeof(step) + measures + notes + flights + variants +
           (changesScene(step) ? 2 * bytesOf(*step.after.scene) : 0);
}

bool changesAnything(const EditStep& step) {
    return changesScene(step) || changesSettings(step) || changesCamera(step) || changesModelUnits(step) ||
           changesBookmarks(step) || changesMeasures(step) || changesNotes(step) || changesFlights(step) ||
           changesVariants(step);
}

} // namespace

bool changesScene(const EditStep& step) { return step.before.scene != step.after.scene; }

bool changesSettings(const EditStep& step) { return step.before.settings != step.after.settings; }

bool changesCamera(const EditStep& step) { return step.before.camera != step.after.camera; }
bool changesModelUnits(const EditStep& step) {
    const rtcore::ModelUnits &before = step.before.modelUnits, &after = step.after.modelUnits;
    return before.up != after.up || before.metresPerUnit != after.metresPerUnit;
}

bool changesBookmarks(const EditStep& step) { return step.before.bookmarks != step.after.bookmarks; }

bool changesMeasures(const EditStep& step) { return step.before.measures != step.after.measures; }

bool changesNotes(const EditStep& step) { return step.before.notes != step.after.notes; }

bool changesFlights(const EditStep& step) { return step.before.flights != step.after.flights; }

bool changesVariants(const EditStep& step) { return step.before.variants != step.after.variants; }

bool placesOnlyTheCamera(const EditStep& step) {
    return changesCamera(step) && !changesScene(step) && !changesSettings(step) && !changesModelUnits(step) &&
           !changesBookmarks(step) && !changesMeasures(step) && !changesNotes(step) &&
           !changesFlights(step) && !changesVariants(step);
}

void EditHistory::add(EditStep step, bool goesOn) {
    if (!changesAnything(step)) return;
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(done_), steps_.end());
    if (goesOn && continues(step)) return joinToLast(std::move(step.after));
    step.state = stateBehind(step, state());
    step.number = ++numbers_;
    steps_.push_back(std::move(step));
    forgetFirst();
    done_ = steps_.size();
    if (done_ > kStepsWithMaps) dropSkyMaps(steps_[done_ - 1 - kStepsWithMaps]);
}

// Commands of a shell are clients of their own each, and say nothing of persons.
bool EditHistory::continues(const EditStep& step) const {
    if (last() == nullptr || last()->label != step.label || last()->by.person != step.by.person) return false;
    return step.by.person == 0 || last()->by.client == step.by.client;
}

std::uint64_t EditHistory::stateBehind(const EditStep& step, std::uint64_t before) {
    return placesOnlyTheCamera(step) ? before : ++newest_;
}

void EditHistory::forgetFirst() {
    const auto plus = [](std::size_t bytes, const EditStep& step) { return bytes + bytesOf(step); };
    std::size_t bytes = std::accumulate(steps_.begin(), steps_.end(), std::size_t{0}, plus);
    while (steps_.size() > kMaxSteps || (steps_.size() > kFewestSteps && bytes > kMaxBytes)) {
        bytes -= bytesOf(steps_.front());
        base_ = steps_.front().state;
        steps_.pop_front();
        ++forgotten_;
    }
}

void EditHistory::joinToLast(Snapshot after) {
    EditStep& step = steps_.back();
    step.after = std::move(after);
    step.state = stateBehind(step, steps_.size() > 1 ? steps_[steps_.size() - 2].state : base_);
    if (changesAnything(step)) return;
    steps_.pop_back();
    done_ = steps_.size();
}

bool EditHistory::hasNotes(const std::function<bool(const Notes&)>& of) const {
    return std::ranges::any_of(
        steps_, [&](const EditStep& step) { return of(step.before.notes) || of(step.after.notes); });
}

void EditHistory::replaceNotes(const std::function<Notes(const Notes&)>& by) {
    std::uint64_t before = std::exchange(base_, ++newest_), now = base_;
    for (EditStep& step : steps_) {
        step.before.notes = by(step.before.notes);
        step.after.notes = by(step.after.notes);
        const bool same = std::exchange(before, step.state) == step.state; // it placed the camera alone
        step.state = now = same ? now : ++newest_;
    }
}

void EditHistory::clear() {
    steps_.clear();
    done_ = 0;
    forgotten_ = 0;
    base_ = first_ = ++newest_;
}

} // namespace rtserver

#include "rtserver/edit_history.h"

#include <utility>

namespace rtserver {

namespace {

constexpr std::size_t kMostSteps = 500;

bool changesAnything(const EditStep& step) {
    return changesScene(step) || changesSettings(step) || changesCamera(step) || changesFrame(step);
}

} // namespace

bool changesScene(const EditStep& step) { return step.before.scene != step.after.scene; }

bool changesSettings(const EditStep& step) { return step.before.settings != step.after.settings; }

bool changesCamera(const EditStep& step) { return step.before.camera != step.after.camera; }
bool changesFrame(const EditStep& step) {
    const rtcore::UpAndUnit &before = step.before.frame, &after = step.after.frame;
    return before.up != after.up || before.metresPerUnit != after.metresPerUnit;
}

void EditHistory::add(EditStep step, bool goesOn) {
    if (!changesAnything(step)) return;
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(done_), steps_.end());
    if (goesOn && last() != nullptr && last()->label == step.label) return joinToLast(std::move(step.after));
    steps_.push_back(std::move(step));
    if (steps_.size() > kMostSteps) {
        steps_.pop_front();
        ++forgotten_;
    }
    done_ = steps_.size();
}

void EditHistory::joinToLast(Shown after) {
    steps_.back().after = std::move(after);
    if (changesAnything(steps_.back())) return;
    steps_.pop_back();
    done_ = steps_.size();
}

void EditHistory::clear() {
    steps_.clear();
    done_ = 0;
    forgotten_ = 0;
}

} // namespace rtserver

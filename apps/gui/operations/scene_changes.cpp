#include "gui/operations/scene_changes.h"

#include "gui/models/setting_labels.h"

#include <QDateTime>

#include <utility>

namespace gui {

namespace {

constexpr qint64 kOneGesture = 1000; ///< milliseconds

std::string setCommand(const QString& name, const QString& value) {
    return command::set(name.toStdString(), value.toStdString());
}

} // namespace

SettingChange::SettingChange(SceneEditor& editor, const QString& name, const QString& before,
                             const QString& after)
    : QUndoCommand(settingLabel(name.toStdString())), editor_(editor), name_(name), before_(before),
      after_(after), time_(QDateTime::currentMSecsSinceEpoch()) {}

void SettingChange::undo() { editor_.apply({setCommand(name_, before_)}); }

void SettingChange::redo() {
    if (!std::exchange(done_, false)) editor_.apply({setCommand(name_, after_)});
}

bool SettingChange::mergeWith(const QUndoCommand* other) {
    const auto* next = static_cast<const SettingChange*>(other);
    if (next->name_ != name_ || next->time_ - time_ > kOneGesture) return false;
    after_ = next->after_;
    time_ = next->time_;
    setObsolete(after_ == before_);
    return true;
}

StateChange::StateChange(SceneEditor& editor, const QString& label, SceneState before, SceneState after)
    : QUndoCommand(label), editor_(editor), before_(std::move(before)), after_(std::move(after)) {}

void StateChange::undo() { editor_.apply(commandsBetween(after_, before_)); }
void StateChange::redo() { editor_.apply(commandsBetween(before_, after_)); }

PlacementChange::PlacementChange(SceneEditor& editor, const QString& label, Placement before, Placement after)
    : QUndoCommand(label), editor_(editor), before_(std::move(before)), after_(std::move(after)) {}

void PlacementChange::undo() { editor_.apply(after_, before_); }

void PlacementChange::redo() {
    if (!std::exchange(done_, false)) editor_.apply(before_, after_);
}

} // namespace gui

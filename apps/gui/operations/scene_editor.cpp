#include "gui/operations/scene_editor.h"

#include "gui/models/edit_labels.h"

#include "common/commands/command_lookup.h"

#include <utility>

namespace gui {

SceneEditor::SceneEditor(Session& session, QObject* parent) : QObject(parent), session_(session) {
    connect(&session_, &Session::stateChanged, this, &SceneEditor::onSession);
    connect(&session_, &Session::statusChanged, this, &SceneEditor::onStatus);
    connect(&own_, &QUndoStack::indexChanged, this, &SceneEditor::stateChanged);
}

void SceneEditor::onSession() {
    if (std::exchange(live_, session_.live()) == session_.live()) return;
    follower_.forget();
    edits_.forget();
    forgetOwn();
    if (live_) return refresh();
    take({}, {});
}

// --- The server's state ---

void SceneEditor::onStatus() {
    follower_.revision(session_.status().stateRevision);
    ask();
}

void SceneEditor::refresh() {
    follower_.want();
    ask();
}

void SceneEditor::ask() {
    if (!session_.live() || !follower_.asks()) return;
    session_.send(command::state(), this, [this](const Answer& answer) {
        const auto report = answer.done ? readState(answer.text) : std::nullopt;
        if (follower_.answered(answer.done) && report) take(report->state, report->scene);
        ask();
    });
}

void SceneEditor::take(const SceneState& state, QString scene) {
    const bool another = scene != scene_;
    scene_ = std::move(scene);
    const bool changed = state != state_;
    state_ = state;
    if (another) forgetOwn();
    if (another) emit sceneChanged();
    if (changed || another) emit stateChanged();
}

// --- Edits ---

void SceneEditor::beginChange(const std::string& line) {
    follower_.edits();
    if (app::effectOf(line) != app::CommandEffect::Keeps) emit sending();
}

void SceneEditor::setSetting(const QString& name, const QString& value) {
    const std::string line = command::set(name.toStdString(), value.toStdString());
    const std::string thing = "set " + name.toStdString();
    if (!edits_.isBusy(thing) && follower_.isCurrent() && state_.settings.value(name) == value) return;
    follow(QString::fromStdString(thing), line);
}

void SceneEditor::follow(const QString& step, const std::string& line, std::optional<bool> goesOn) {
    beginChange(line);
    const std::string thing = step.toStdString();
    if (const auto now = edits_.edit(thing, line, goesOn)) send(thing, *now);
}

void SceneEditor::send(const std::string& thing, const std::string& line) {
    session_.send(line, this, [this, thing](const Answer& answer) { onAnswer(thing, answer); });
}

void SceneEditor::onAnswer(const std::string& thing, const Answer& answer) {
    follower_.edits();
    if (const auto next = edits_.answered(thing)) return send(thing, *next);
    onRefusal(answer);
    refresh();
}

void SceneEditor::onRefusal(const Answer& answer) {
    if (answer.done) return;
    emit refused(answer.text);
    emit stateChanged(); // panels go back to the actual state
}

void SceneEditor::edit(const std::string& line, std::function<void(const Answer&)> done) {
    beginChange(line);
    session_.send(line, this, [this, done = std::move(done)](const Answer& answer) {
        follower_.edits();
        done ? done(answer) : onRefusal(answer);
        refresh();
    });
}

void SceneEditor::setDefaults() { edit(command::defaults()); }
void SceneEditor::switchLight(int id, bool on) { edit(command::light(id, on)); }
void SceneEditor::chooseEnvironment(int environment) { edit(command::environment(environment + 1)); }

// --- Undo ---

bool SceneEditor::ownIsLast() const { return own_.canUndo() && owns_[own_.index() - 1].at >= state_.edits; }

bool SceneEditor::ownIsNext() const {
    if (!own_.canRedo()) return false;
    const Own& next = owns_[own_.index()];
    return next.at - (next.both ? 1 : 0) <= state_.edits;
}

void SceneEditor::undo() {
    edits_.endGesture();
    if (!ownIsLast()) return edit(command::undo());
    // An edit that changed nothing, such as to a name that it had, is none.
    const Own last = owns_[own_.index() - 1];
    const bool both = last.both && (!follower_.isCurrent() || state_.edits >= last.at);
    own_.undo();
    if (both) edit(command::undo());
}

void SceneEditor::redo() {
    edits_.endGesture();
    if (!ownIsNext()) return edit(command::redo());
    const bool both = owns_[own_.index()].both && (!follower_.isCurrent() || !state_.redo.isEmpty());
    own_.redo();
    if (both) edit(command::redo());
}

QString SceneEditor::undoText() const { return ownIsLast() ? own_.undoText() : editLabel(state_.undo); }
QString SceneEditor::redoText() const { return ownIsNext() ? own_.redoText() : editLabel(state_.redo); }

void SceneEditor::keepOwn(QUndoCommand* step, bool both) {
    owns_.resize(own_.index());
    owns_.append({++lastOwn_, state_.edits + (both ? 1 : 0), both});
    own_.push(step);
}

void SceneEditor::doOwn(QUndoCommand* step) { keepOwn(step, false); }

void SceneEditor::doBoth(QUndoCommand* step, const std::string& line) {
    keepOwn(step, true);
    edit(line, [this, id = lastOwn_](const Answer& answer) {
        if (!answer.done) part(id);
        onRefusal(answer);
    });
}

// Its edit was refused.
void SceneEditor::part(int id) {
    for (Own& own : owns_) {
        if (own.id != id || !own.both) continue;
        own.both = false;
        --own.at;
    }
}

void SceneEditor::forgetOwn() {
    owns_.clear();
    own_.clear();
}

} // namespace gui

#include "gui/operations/scene_editor.h"

#include "gui/models/edit_labels.h"

#include <utility>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kTick = 200ms;
constexpr qint64 kCalm = 1000, kSeldom = 5000; ///< milliseconds between questions: frames come, or none does

} // namespace

SceneEditor::SceneEditor(Session& session, QObject* parent) : QObject(parent), session_(session) {
    connect(&session_, &Session::stateChanged, this, &SceneEditor::onSession);
    connect(&session_, &Session::statusChanged, this, [this] {
        const bool loads = session_.status().progress < 1;
        if (std::exchange(loading_, loads) && !loads) refresh(); // whichever client had it loaded
    });
    connect(&own_, &QUndoStack::indexChanged, this, &SceneEditor::stateChanged);
    connect(&timer_, &QTimer::timeout, this, &SceneEditor::look);
    sinceAsked_.start();
    sinceSet_.start();
    timer_.start(kTick);
}

void SceneEditor::onSession() {
    if (std::exchange(live_, session_.live()) == session_.live()) return;
    asking_ = askAgain_ = false;
    ++changes_;
    sending_.clear();
    following_.clear();
    forgetOwn();
    if (live_) return refresh();
    take({}, {});
}

// --- What the server has ---

// Whatever changes the scene makes a new frame.
void SceneEditor::look() {
    if (!live_ || asking_) return;
    const bool moved = session_.frameNumber() != askedAt_;
    const qint64 wait = !moved ? kSeldom : session_.status().idle ? 0 : kCalm;
    if (sinceAsked_.elapsed() >= wait) ask();
}

void SceneEditor::refresh() {
    if (!session_.live()) return;
    if (asking_) {
        askAgain_ = true;
        return;
    }
    ask();
}

void SceneEditor::ask() {
    asking_ = true;
    sinceAsked_.restart();
    askedAt_ = session_.frameNumber();
    session_.send(command::state(), this, [this, changes = changes_](const Answer& answer) {
        asking_ = false;
        // What was asked before a change of ours would take the change back in the panels.
        if (changes != changes_) return refresh();
        if (const auto report = answer.done ? readState(answer.text) : std::nullopt)
            take(report->state, report->scene);
        if (std::exchange(askAgain_, false)) refresh();
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

void SceneEditor::beginChange() {
    ++changes_;
    emit sending();
}

void SceneEditor::setSetting(const QString& name, const QString& value) {
    Sending& sending = sending_[name];
    if (!sending.underWay && state_.settings.value(name) == value) return;
    beginChange();
    sending.next = value;
    if (!sending.underWay) sendSetting(name);
}

void SceneEditor::sendSetting(const QString& name) {
    Sending& sending = sending_[name];
    const QString value = *std::exchange(sending.next, std::nullopt);
    sending.underWay = true;
    const bool goesOn = lastSet_ == name && sinceSet_.elapsed() < kOneGesture;
    lastSet_ = name;
    sinceSet_.restart();
    const std::string line = command::set(name.toStdString(), value.toStdString());
    session_.send(goesOn ? command::also(line) : line, this,
                  [this, name, value](const Answer& answer) { onSetting(name, value, answer); });
}

void SceneEditor::onSetting(const QString& name, const QString& value, const Answer& answer) {
    ++changes_;
    Sending& sending = sending_[name];
    sending.underWay = false;
    if (answer.done && state_.settings.contains(name)) state_.settings[name] = value;
    if (!answer.done) onRefusal(answer);
    if (sending.next) return sendSetting(name);
    emit stateChanged();
    refresh();
}

void SceneEditor::onRefusal(const Answer& answer) {
    if (answer.done) return;
    emit refused(answer.text);
    emit stateChanged(); // what is shown goes back to what is
}

void SceneEditor::edit(const std::string& line, std::function<void(const Answer&)> done) {
    beginChange();
    session_.send(line, this, [this, done = std::move(done)](const Answer& answer) {
        ++changes_;
        done ? done(answer) : onRefusal(answer);
        refresh();
    });
}

void SceneEditor::follow(const QString& step, const std::string& line, std::optional<bool> goesOn) {
    Following& following = following_[step];
    const bool soon = lastSet_ == step && sinceSet_.elapsed() < kOneGesture;
    const bool joins = goesOn.value_or(soon);
    // What takes the place of the first line of a step begins it.
    following.goesOn = following.next ? following.goesOn && joins : joins;
    following.next = line;
    lastSet_ = step;
    sinceSet_.restart();
    beginChange();
    if (!following.underWay) sendFollowing(step);
}

void SceneEditor::sendFollowing(const QString& step) {
    Following& following = following_[step];
    following.underWay = true;
    const std::string line = *std::exchange(following.next, std::nullopt);
    session_.send(following.goesOn ? command::also(line) : line, this, [this, step](const Answer& answer) {
        ++changes_;
        Following& sent = following_[step];
        sent.underWay = false;
        if (sent.next) return sendFollowing(step);
        onRefusal(answer);
        refresh();
    });
}

void SceneEditor::setDefaults() { edit(command::defaults()); }
void SceneEditor::switchLight(int id, bool on) { edit(command::light(id, on)); }
void SceneEditor::chooseEnvironment(int environment) { edit(command::environment(environment + 1)); }

// --- Undo ---

bool SceneEditor::ownIsLast() const { return own_.canUndo() && ownAt_[own_.index() - 1] >= state_.edits; }
bool SceneEditor::ownIsNext() const { return own_.canRedo() && ownAt_[own_.index()] <= state_.edits; }

void SceneEditor::undo() {
    lastSet_.clear();
    ownIsLast() ? own_.undo() : edit(command::undo());
}

void SceneEditor::redo() {
    lastSet_.clear();
    ownIsNext() ? own_.redo() : edit(command::redo());
}

QString SceneEditor::undoText() const { return ownIsLast() ? own_.undoText() : editLabel(state_.undo); }
QString SceneEditor::redoText() const { return ownIsNext() ? own_.redoText() : editLabel(state_.redo); }

void SceneEditor::doOwn(QUndoCommand* step) {
    ownAt_.resize(own_.index());
    ownAt_.append(state_.edits);
    own_.push(step);
}

void SceneEditor::forgetOwn() {
    ownAt_.clear();
    own_.clear();
}

} // namespace gui

#include "gui/operations/scene_editor.h"

#include "gui/operations/scene_changes.h"

#include "rtcore/settings/settings_table.h"

#include <utility>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kTick = 200ms;
constexpr qint64 kCalm = 1000, kSeldom = 5000; ///< milliseconds between questions: frames come, or none does
constexpr int kMostUndoSteps = 500;

} // namespace

SceneEditor::SceneEditor(Session& session, QObject* parent) : QObject(parent), session_(session) {
    undo_.setUndoLimit(kMostUndoSteps);
    connect(&session_, &Session::stateChanged, this, &SceneEditor::onSession);
    connect(&session_, &Session::statusChanged, this, [this] {
        const bool loads = session_.status().progress < 1;
        if (std::exchange(loading_, loads) && !loads) refresh(); // whichever client had it loaded
    });
    connect(&timer_, &QTimer::timeout, this, &SceneEditor::look);
    sinceAsked_.start();
    timer_.start(kTick);
}

void SceneEditor::onSession() {
    if (std::exchange(live_, session_.live()) == session_.live()) return;
    asking_ = askAgain_ = false;
    ++changes_;
    sending_.clear();
    undo_.clear();
    if (live_) return refresh();
    take({}, {});
}

// --- What the server has ---

void SceneEditor::watch(const QObject* user, bool looks) {
    looks ? void(watchers_.insert(user)) : void(watchers_.remove(user));
    if (looks) refresh();
}

// Whatever changes the scene makes a new frame.
void SceneEditor::look() {
    if (watchers_.isEmpty() || !live_ || asking_) return;
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
    askPlacement([this, changes = changes_](const std::optional<Placement>& now) {
        asking_ = false;
        // What was asked before a change of ours would take the change back in the panels.
        if (changes != changes_) return refresh();
        if (now) take(now->state, now->scene);
        if (std::exchange(askAgain_, false)) refresh();
    });
}

void SceneEditor::take(const SceneState& state, QString scene) {
    const bool another = scene != scene_;
    scene_ = std::move(scene);
    const bool changed = state != state_;
    state_ = state;
    if (another) undo_.clear();
    if (another) emit sceneChanged();
    if (changed || another) emit stateChanged();
}

void SceneEditor::askPlacement(std::function<void(const std::optional<Placement>&)> use) {
    session_.send(command::state(), this, [use = std::move(use)](const Answer& answer) {
        use(answer.done ? readPlacement(answer.text) : std::nullopt);
    });
}

SceneEditor::Before SceneEditor::askPlacement() {
    const auto before = std::make_shared<std::optional<Placement>>();
    askPlacement([before](const std::optional<Placement>& now) { *before = now; });
    return before;
}

// --- Settings, lights, environment ---

void SceneEditor::setSetting(const QString& name, const QString& value) {
    Sending& sending = sending_[name];
    if (!sending.underWay && state_.settings.value(name) == value) return;
    ++changes_;
    sending.next = value;
    if (!sending.underWay) sendSetting(name);
}

void SceneEditor::sendSetting(const QString& name) {
    Sending& sending = sending_[name];
    const QString value = *std::exchange(sending.next, std::nullopt);
    sending.underWay = true;
    session_.send(command::set(name.toStdString(), value.toStdString()), this,
                  [this, name, before = state_.settings.value(name), value](const Answer& answer) {
                      onSetting(name, before, value, answer);
                  });
}

void SceneEditor::onSetting(const QString& name, const QString& before, const QString& value,
                            const Answer& answer) {
    ++changes_;
    Sending& sending = sending_[name];
    sending.underWay = false;
    if (answer.done && state_.settings.contains(name)) {
        state_.settings[name] = value;
        undo_.push(new SettingChange(*this, name, before, value));
    }
    if (!answer.done) onRefusal(answer);
    if (sending.next) return sendSetting(name);
    emit stateChanged();
    refresh();
}

void SceneEditor::onRefusal(const Answer& answer) {
    if (answer.done) return;
    emit refused(answer.text);
    emit stateChanged(); // what is shown goes back to what is
    refresh();
}

void SceneEditor::change(const SceneState& to, const QString& label) {
    if (to == state_) return;
    undo_.push(new StateChange(*this, label, state_, to));
}

// The image's size is the window's, not a matter of taste.
void SceneEditor::setDefaults() {
    SceneState to = state_;
    for (const rtcore::Setting& setting : rtcore::settingsTable()) {
        const QString name = QString::fromStdString(std::string(setting.name));
        if (isPictureSize(name) || !to.settings.contains(name)) continue;
        to.settings[name] = QString::fromStdString(rtcore::settingText(setting.defaultValue));
    }
    change(to, tr("defaults"));
}

void SceneEditor::switchLight(int light, bool on) {
    SceneState to = state_;
    if (light < 0 || light >= to.lights.size()) return;
    to.lights[light].on = on;
    change(to, tr("light"));
}

void SceneEditor::chooseEnvironment(int environment) {
    SceneState to = state_;
    if (environment < 0 || environment >= to.environments.size()) return;
    for (int i = 0; i < to.environments.size(); ++i) to.environments[i].on = i == environment;
    change(to, tr("environment"));
}

void SceneEditor::apply(const std::vector<std::string>& lines) {
    ++changes_;
    for (const std::string& line : lines)
        session_.send(line, this, [this](const Answer& answer) { onRefusal(answer); });
    refresh();
}

// --- The camera ---

// Before, command, after: the server keeps their order.
void SceneEditor::place(const std::string& line, const QString& label,
                        std::function<void(const Answer&)> done) {
    const Before before = askPlacement();
    ++changes_;
    session_.send(line, this, [this, before, label, done = std::move(done)](const Answer& answer) {
        if (answer.done) finishPlacement(before, label);
        done ? done(answer) : onRefusal(answer);
    });
}

void SceneEditor::placeByText(const QString& camera, const QString& label,
                              std::function<void(const Answer&)> done) {
    const std::optional<rtcore::CameraFile> file = readCameraText(camera);
    if (!file) return done({});
    askPlacement([this, file, label, done = std::move(done)](const std::optional<Placement>& before) {
        if (!before) return done({});
        applyCameraFile(*file, *before, [this, before, label, done](const Answer& answer) {
            if (answer.done) finishPlacement(std::make_shared<std::optional<Placement>>(before), label);
            done(answer);
        });
    });
}

// All is sent at once; the camera is answered for last. When a part is refused, the others are taken back.
void SceneEditor::applyCameraFile(const rtcore::CameraFile& file, const Placement& before,
                                  std::function<void(const Answer&)> done) {
    ++changes_;
    const SceneState after = withCameraFile(before.state, file);
    const auto refusal = std::make_shared<std::optional<Answer>>();
    const auto collect = [refusal](const Answer& answer) {
        if (!answer.done && !*refusal) *refusal = answer;
    };
    for (const std::string& line : commandsBetween(before.state, after)) session_.send(line, this, collect);
    session_.send(cameraCommand(file.camera), this,
                  [this, before, after, collect, refusal, done = std::move(done)](const Answer& answer) {
                      collect(answer);
                      if (!*refusal) return done(answer);
                      if (answer.done)
                          session_.send(cameraCommand(before.camera), this, [](const Answer&) {});
                      apply(commandsBetween(after, before.state));
                      done(**refusal);
                  });
}

std::function<void()> SceneEditor::beginPlacement(const QString& label) {
    return [this, before = askPlacement(), label] { finishPlacement(before, label); };
}

void SceneEditor::finishPlacement(const Before& before, const QString& label) {
    askPlacement([this, before, label, stage = changes_](const std::optional<Placement>& now) {
        if (!now) return;
        const Placement then = before->value_or(*now);
        if (now->camera != then.camera || now->state != then.state)
            undo_.push(new PlacementChange(*this, label, then, *now));
        if (stage == changes_) take(now->state, now->scene);
    });
}

void SceneEditor::apply(const Placement& from, const Placement& to) {
    ++changes_;
    if (from.camera != to.camera)
        session_.send(cameraCommand(to.camera), this, [this](const Answer& answer) { onRefusal(answer); });
    apply(commandsBetween(from.state, to.state));
}

} // namespace gui

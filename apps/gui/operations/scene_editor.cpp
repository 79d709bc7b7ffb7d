#include "gui/operations/scene_editor.h"

#include "gui/operations/scene_changes.h"

#include "rtcore/settings/settings_table.h"

#include <QDir>
#include <QTemporaryFile>

#include <utility>

namespace gui {

namespace {

using namespace std::chrono_literals;

constexpr auto kTick = 200ms;
constexpr qint64 kCalm = 1000, kSeldom = 5000; ///< milliseconds between questions: frames come, or none does
constexpr int kMostSteps = 500;

} // namespace

SceneEditor::SceneEditor(Session& session, QObject* parent) : QObject(parent), session_(session) {
    undo_.setUndoLimit(kMostSteps);
    connect(&session_, &Session::stateChanged, this, &SceneEditor::onSession);
    connect(&session_, &Session::statusChanged, this, [this] {
        const bool loads = session_.status().progress < 1;
        if (std::exchange(loading_, loads) && !loads) refresh(); // whoever had it loaded
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
    const quint64 changes = changes_;
    auto scene = std::make_shared<QString>();
    session_.send(QStringLiteral("scene"), this,
                  [scene](const Answer& answer) { *scene = answer.done ? answer.text : QString(); });
    auto known = std::make_shared<std::shared_ptr<Placement>>();
    *known = askPlacement([this, changes, scene, known] {
        asking_ = false;
        // What was asked before a change of ours would take the change back in the panels.
        if (changes != changes_) return refresh();
        if (!scene->isEmpty() && !(*known)->state.settings.isEmpty()) take((*known)->state, *scene);
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

std::shared_ptr<Placement> SceneEditor::askPlacement(std::function<void()> known) {
    auto placement = std::make_shared<Placement>();
    session_.send(QStringLiteral("camera get"), this, [placement](const Answer& answer) {
        if (answer.done) placement->camera = answer.text;
    });
    session_.send(QStringLiteral("settings"), this, [placement](const Answer& answer) {
        if (answer.done) placement->state.settings = readSettings(answer.text);
    });
    session_.send(QStringLiteral("lights"), this, [placement](const Answer& answer) {
        if (answer.done) placement->state.lights = readSwitches(answer.text);
    });
    session_.send(QStringLiteral("environments"), this,
                  [placement, known = std::move(known)](const Answer& answer) {
                      if (answer.done) placement->state.environments = readSwitches(answer.text);
                      if (known) known();
                  });
    return placement;
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
    session_.send(Session::line({QStringLiteral("set"), name, value}), this,
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

// The picture's size is the window's, not a matter of taste.
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

void SceneEditor::apply(const QStringList& commands) {
    ++changes_;
    for (const QString& command : commands)
        session_.send(command, this, [this](const Answer& answer) { onRefusal(answer); });
    refresh();
}

// --- The camera ---

// Before, command, after: the server keeps their order.
void SceneEditor::place(const QString& command, const QString& label,
                        std::function<void(const Answer&)> done) {
    const std::shared_ptr<Placement> before = askPlacement();
    ++changes_;
    session_.send(command, this, [this, before, label, done = std::move(done)](const Answer& answer) {
        if (answer.done) finishPlacement(before, label);
        if (done)
            done(answer);
        else
            onRefusal(answer);
    });
}

void SceneEditor::placeByText(const QString& camera, const QString& label,
                              std::function<void(const Answer&)> done) {
    const std::shared_ptr<Placement> before = askPlacement();
    ++changes_;
    loadCamera(camera, [this, before, label, done = std::move(done)](const Answer& answer) {
        if (answer.done) finishPlacement(before, label);
        if (done)
            done(answer);
        else
            onRefusal(answer);
    });
}

std::function<void()> SceneEditor::beginPlacement(const QString& label) {
    return [this, before = askPlacement(), label] { finishPlacement(before, label); };
}

void SceneEditor::finishPlacement(const std::shared_ptr<Placement>& before, const QString& label) {
    const quint64 stage = changes_;
    auto after = std::make_shared<std::shared_ptr<Placement>>();
    *after = askPlacement([this, before, after, label, stage] {
        const Placement& now = **after;
        const bool known = !before->camera.isEmpty() && !now.camera.isEmpty();
        const bool changed = now.camera != before->camera || now.state != before->state;
        if (known && changed) undo_.push(new PlacementChange(*this, label, *before, now));
        if (stage == changes_) take(now.state, scene_);
    });
}

// The server reads cameras from files.
void SceneEditor::loadCamera(const QString& camera, std::function<void(const Answer&)> done) {
    auto file = std::make_shared<QTemporaryFile>(QDir::tempPath() + QStringLiteral("/camera-XXXXXX.cam"));
    const QByteArray text = camera.toUtf8();
    if (!file->open() || file->write(text) != text.size() || !file->flush()) {
        done({false, file->errorString()});
        return;
    }
    session_.send(Session::line({QStringLiteral("load"), QStringLiteral("camera"), file->fileName()}), this,
                  [file, done = std::move(done)](const Answer& answer) { done(answer); });
}

void SceneEditor::apply(const Placement& from, const Placement& to) {
    ++changes_;
    if (from.camera != to.camera) loadCamera(to.camera, [this](const Answer& answer) { onRefusal(answer); });
    apply(commandsBetween(from.state, to.state));
}

} // namespace gui

/// What the user changes in the scene: settings, lights, environment, the place of the camera. Keeps what the
/// server says of them, and takes changes back.
#pragma once

#include "gui/models/scene_state.h"
#include "gui/session/session.h"

#include <QElapsedTimer>
#include <QHash>
#include <QObject>
#include <QSet>
#include <QTimer>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gui {

class SceneEditor : public QObject {
    Q_OBJECT

  public:
    /// `session` must outlive it.
    explicit SceneEditor(Session& session, QObject* parent = nullptr);

    const SceneState& state() const { return state_; }
    /// Absolute path of what the server shows; empty while it is not known.
    const QString& scene() const { return scene_; }
    QUndoStack& undoStack() { return undo_; }
    /// Asks the server after new frames while at least one panel is visible; each panel says so for itself.
    void watch(const QObject* user, bool looks);
    void refresh();

    // Each of these can be taken back. What the server refuses is told by refused(), and is not on the stack.
    /// Of several values for one name in short order the server gets the newest.
    void setSetting(const QString& name, const QString& value);
    void setDefaults();
    void switchLight(int light, bool on);
    void chooseEnvironment(int environment);
    /// Sends a command that places the camera; `label` for the menu, `done` with the server's answer.
    void place(const std::string& line, const QString& label, std::function<void(const Answer&)> done = {});
    /// The same by a .cam file's text. Fails, with nothing changed, when it is none, or when the server
    /// refuses a part of it.
    void placeByText(const QString& camera, const QString& label, std::function<void(const Answer&)> done);
    /// Around changes that are sent elsewhere, such as one movement of many steps: call the result after the
    /// last one.
    std::function<void()> beginPlacement(const QString& label);

    // For the undo stack: nothing new comes onto it.
    void apply(const std::vector<std::string>& lines);
    void apply(const Placement& from, const Placement& to);

  signals:
    void stateChanged();
    void sceneChanged();
    /// A change of the user's was not taken.
    void refused(const QString& text);

  private:
    void onSession();
    void look();
    void ask();
    void take(const SceneState& state, QString scene);
    void sendSetting(const QString& name);
    void onSetting(const QString& name, const QString& before, const QString& value, const Answer& answer);
    void change(const SceneState& to, const QString& label);
    /// What there was before a change; filled when the answer comes, before that to what is sent later.
    using Before = std::shared_ptr<std::optional<Placement>>;
    Before askPlacement();
    void askPlacement(std::function<void(const std::optional<Placement>&)> use);
    void finishPlacement(const Before& before, const QString& label);
    void applyCameraFile(const rtcore::CameraFile& file, const Placement& before,
                         std::function<void(const Answer&)> done);
    void onRefusal(const Answer& answer);

    struct Sending {
        bool underWay = false;
        std::optional<QString> next; ///< the newest wish
    };

    Session& session_;
    SceneState state_;
    QString scene_;
    QUndoStack undo_;
    QTimer timer_;
    QElapsedTimer sinceAsked_;
    QSet<const QObject*> watchers_;
    QHash<QString, Sending> sending_; ///< by name of the setting
    quint64 changes_ = 0;             ///< sent by us: an answer to an older question is out of date
    quint64 askedAt_ = 0;             ///< number of the frame
    bool live_ = false, loading_ = false, asking_ = false, askAgain_ = false;
};

} // namespace gui

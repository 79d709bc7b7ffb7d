/// The user's changes to the scene: settings, lights, environment, the place of the camera. Keeps their state
/// as the server reports it. The server keeps the steps that can be taken back, those of other clients, too.
#pragma once

#include "gui/models/scene_state.h"
#include "gui/session/session.h"

#include "common/mirror/edit_queue.h"
#include "common/mirror/state_follower.h"

#include <QList>
#include <QObject>
#include <QUndoStack>

#include <functional>
#include <optional>
#include <string>

namespace gui {

class SceneEditor : public QObject {
    Q_OBJECT

  public:
    static constexpr qint64 kOneGesture = app::EditQueue::kOneGesture.count(); ///< milliseconds

    /// `session` must outlive it.
    explicit SceneEditor(Session& session, QObject* parent = nullptr);

    const SceneState& state() const { return state_; }
    /// Absolute path of what the server shows; empty while it is not known.
    const QString& scene() const { return scene_; }
    void refresh();

    // Refusals of the server are reported by refused().
    /// The server gets the newest of several values for one name in quick succession; those of one gesture
    /// are one step.
    void setSetting(const QString& name, const QString& value);
    void setDefaults();
    void switchLight(int id, bool on);
    /// The server gets the newest of several lines for one step (EditStep::label, as "light move 2") in quick
    /// succession. `goesOn`: the line belongs to the step of the last one, if that was of the same thing;
    /// nothing: by the time in between, as those of one gesture do.
    void follow(const QString& step, const std::string& line, std::optional<bool> goesOn = {});
    void chooseEnvironment(int environment);
    /// Sends a command that edits. `done` gets the server's answer, and tells a refusal itself.
    void edit(const std::string& line, std::function<void(const Answer&)> done = {});

    /// Take the last step back, or make it again: the window's own or the server's, in their order.
    void undo();
    void redo();
    /// Labels of the steps that these would take, as menus show them; empty: there is none.
    QString undoText() const;
    QString redoText() const;
    /// Does something of the window's own that can be taken back until another scene is shown.
    void doOwn(QUndoCommand* step);
    /// The same together with an edit of the server: both are one step. A refusal of the edit is reported,
    /// and leaves the window's own part.
    void doBoth(QUndoCommand* step, const std::string& line);

  signals:
    /// A change of what is seen, by the user, is on its way.
    void sending();
    /// Also when undoText() or redoText() changes.
    void stateChanged();
    void sceneChanged();
    /// A change of the user's was not taken.
    void refused(const QString& text);

  private:
    void onSession();
    void onStatus();
    void ask();
    void take(const SceneState& state, QString scene);
    void beginChange(const std::string& line);
    void send(const std::string& thing, const std::string& line);
    void onAnswer(const std::string& thing, const Answer& answer);
    void onRefusal(const Answer& answer);
    bool ownIsLast() const;
    bool ownIsNext() const;
    void keepOwn(QUndoCommand* step, bool both);
    void part(int id);
    void forgetOwn();

    Session& session_;
    SceneState state_;
    QString scene_;
    QUndoStack own_;
    /// Of a step of the window's own.
    struct Own {
        int id;    ///< another number for each
        int at;    ///< after so many of the server's edits
        bool both; ///< the last of which belongs to it
    };
    QList<Own> owns_;
    int lastOwn_ = 0;
    app::StateFollower follower_;
    app::EditQueue edits_;
    bool live_ = false;
};

} // namespace gui

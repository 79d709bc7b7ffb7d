/// The conversation with one server: its frames, its status, commands and keys. Needs no window.
#pragma once

#include "gui/session/server_sentence.h"
#include "gui/session/server_status.h"

#include "common/commands/command_lines.h"

#include <QImage>
#include <QObject>
#include <QString>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace gui {

namespace command = app::command;

enum class SessionState {
    Disconnected, ///< nothing is wanted
    Connecting,   ///< the server is not there yet
    Connected,
    Busy,    ///< the server lives but is silent: it draws a long frame, or is stopped
    Lost,    ///< the server ended or died; a next one of that name is taken at once
    Refused, ///< there is a server that does not suit: another version, another user's, full
};

/// The server's answer to a command.
struct Answer {
    bool done = false;
    QString text;        ///< of a failure: what went wrong, in the user's language
    QString detail = {}; ///< the same for programs (server_sentence.h); may be empty
};

/// One thread, that of its event loop; nothing waits. Frames and answers are looked for every few
/// milliseconds.
class Session : public QObject {
    Q_OBJECT

  public:
    explicit Session(QObject* parent = nullptr);
    ~Session() override;

    /// Leaves the present server. Gives up after `patience` (Disconnected, with a reason).
    void connectTo(const QString& instance, std::chrono::milliseconds patience = std::chrono::seconds(2));
    void leave();

    SessionState state() const { return state_; }
    /// True when commands reach a server.
    bool live() const { return state_ == SessionState::Connected || state_ == SessionState::Busy; }
    const QString& instance() const { return instance_; }
    const QString& reason() const { return reason_; } ///< why Refused, or Disconnected; may be empty
    qint64 serverProcess() const { return process_; }

    /// The newest frame: shares the session's memory and is valid until the next frameChanged() or leave().
    /// Null before the first one; the last one of a dead server stays.
    QImage frame() const;
    /// Counts the frames of one server; 0 before the first one.
    quint64 frameNumber() const;
    /// How long ago the server published the frame.
    std::chrono::nanoseconds frameAge() const;
    const ServerStatus& status() const { return status_; }
    /// Where the camera was when it was last heard of, since connectTo(); a field of view of 0: never.
    const View& lastView() const { return lastView_; }

    /// Sends a line (common/commands/command_lines.h makes them). `done` is called once, later, unless
    /// `context` is gone by then. Commands that a full queue does not take wait here.
    void send(const std::string& command);
    void send(const std::string& command, const QObject* context, std::function<void(const Answer&)> done);

    /// Key codes of rtcore/motion/key_codes.h.
    void pressKey(int key);
    void releaseKey(int key);
    void releaseAllKeys();
    /// Turns the camera; degrees to the right and upwards. Calls that come faster than frames are added up,
    /// also those of orbit(), pan() and approach().
    void turn(double right, double upwards);
    /// Makes the point seen there the pivot of the next three; 0..1 from the left and from the top.
    void takeHold(double right, double down);
    void orbit(double right, double upwards); ///< degrees
    void pan(double right, double upwards);   ///< of the image's width
    void approach(double factor);

  signals:
    void stateChanged(gui::SessionState state);
    void frameChanged();
    void statusChanged();
    /// A command without a waiting caller failed.
    void commandFailed(const QString& command, const QString& text);

  private:
    struct Link;
    void poll();
    void tryToConnect();
    void look();
    void readStatus();
    void sendWaiting();
    void sendSteering();
    void steer();
    void collectAnswers();
    void failAll(const QString& text);
    void become(SessionState state, const QString& reason = {});
    void pace();

    std::unique_ptr<Link> link_;
    SessionState state_ = SessionState::Disconnected;
    QString instance_, reason_;
    qint64 process_ = 0;
    ServerStatus status_;
    View lastView_;
};

} // namespace gui

/// Server and session together: starts servers and connects to them, tells when one died, starts it again
/// where it was, and knows what to do with it when the window closes. Needs no window.
#pragma once

#include "gui/processes/model_cache.h"
#include "gui/processes/server_process.h"
#include "gui/session/session.h"

#include <QObject>
#include <QString>

namespace gui {

class ServerKeeper : public QObject {
    Q_OBJECT

  public:
    explicit ServerKeeper(Session& session, QObject* parent = nullptr);

    /// Starts a server and connects to it. A server of our own that runs is stopped first, unless another
    /// program is connected to it; then it goes on. The name gets a number when it is taken.
    void start(ServerRequest request);
    /// Connects to a server that runs.
    void connectTo(const QString& instance);
    /// Stops the server that the session is connected to, even one that another program started.
    void stop();
    /// True when restart() knows what to start: the last server was ours.
    bool canRestart() const { return !last_.scene.isEmpty(); }
    /// The same scene, the same camera.
    void restart();
    /// Whether our servers, the present one too, go on when the window closes, or is killed. Without that
    /// they end then, unless other clients are connected, and with the last of these.
    void keepServers(bool keep);
    /// Our server shows another scene now.
    void sceneLoaded(const QString& scene);

    /// A process that this window started beside its server; it is not one of the others. 0: none.
    void setCompanion(qint64 process) { companion_ = process; }
    /// Whether a program commands the server that is neither this window nor its companion.
    bool othersUse(const QString& instance) const;
    /// The server has ended, or is about to, and restart() starts one of that name again.
    bool mayComeBack(const QString& instance) const;

    /// The session's server is the one that we started.
    bool ours() const;
    /// Leaves the server as the window closes. The server ends with this object, in up to a few seconds,
    /// unless it is kept or others use it.
    void close();

    const ServerProcess& server() const { return server_; }
    ModelCache& models() { return models_; }                      ///< of what our servers load
    QString scene() const { return ours() ? scene_ : QString(); } ///< empty for others' servers

  signals:
    /// The server is gone without having been asked to: why, in words for the user.
    void died(const QString& text);
    void started(const QString& scene);
    void ready(); ///< the first frame after start() or restart() is there

  private:
    void launch(const ServerRequest& request);
    void leaveOurs();
    bool othersStay(); ///< of our server, which this window leaves
    void onEnded(const QString& text);
    void onState(SessionState state);

    Session& session_;
    ServerProcess server_;
    ModelCache models_;
    ServerRequest last_;
    QString scene_;
    View view_; ///< the one to restart with
    bool waitsForFrame_ = false;
    bool keep_ = false;
    bool asked_ = false; ///< the end of the server is our wish
    bool restarting_ = false;
    qint64 companion_ = 0;
};

} // namespace gui

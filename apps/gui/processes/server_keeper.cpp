#include "gui/processes/server_keeper.h"

#include "gui/session/server_list.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QScopedValueRollback>
#include <QThread>
#include <QTimer>

#include <utility>

namespace gui {

namespace {

constexpr auto kServerPatience =
    std::chrono::seconds(20); ///< for a server's shared memory, not for its scene

// Such a model is another one.
bool importsByOptions(const ServerRequest& request) {
    for (const QString& option : request.options) {
        for (const char* const name : {"--crease", "--deflection", "--flip", "--pose"})
            if (option.startsWith(QLatin1String(name))) return true;
    }
    return false;
}

} // namespace

ServerKeeper::ServerKeeper(Session& session, QObject* parent) : QObject(parent), session_(session) {
    connect(&server_, &ServerProcess::ended, this, &ServerKeeper::onEnded);
    connect(&session_, &Session::stateChanged, this, &ServerKeeper::onState);
    connect(&session_, &Session::frameChanged, this, [this] {
        if (!std::exchange(waitsForFrame_, false)) return;
        if (server_.running() && !importsByOptions(last_)) models_.keep(scene_);
        emit ready();
    });
}

void ServerKeeper::start(ServerRequest request) {
    leaveOurs();
    request.scene = QFileInfo(request.scene).absoluteFilePath();
    request.instance = freeInstanceName(request.instance);
    view_ = {};
    launch(request);
}

void ServerKeeper::launch(const ServerRequest& request) {
    asked_ = false;
    last_ = request;
    scene_ = request.scene;
    waitsForFrame_ = true;
    ServerRequest extended = request;
    extended.keep = keep_;
    const QString light = models_.lightFolder();
    if (!light.isEmpty()) extended.options.append(QStringLiteral("--light-cache=") + light);
    const QString built = importsByOptions(request) ? QString() : models_.find(request.scene);
    if (!built.isEmpty()) extended.options.append(QStringLiteral("--cached-model=") + built);
    server_.start(extended);
    session_.connectTo(request.instance, kServerPatience);
    emit started(request.scene);
}

void ServerKeeper::sceneLoaded(const QString& scene) {
    last_.scene = scene_ = scene;
    if (!importsByOptions(last_)) models_.keep(scene);
}

void ServerKeeper::connectTo(const QString& instance) {
    if (instance != session_.instance()) leaveOurs();
    session_.connectTo(instance);
}

// Our own server is ended, unless other clients are connected to it.
void ServerKeeper::leaveOurs() {
    if (!server_.running()) return;
    if (othersStay()) return server_.release();
    asked_ = true;
    server_.stop();
    QEventLoop loop; // kMax at most: its shared memory has to be free again
    connect(&server_, &ServerProcess::ended, &loop, &QEventLoop::quit);
    constexpr int kMax = 4000;
    QTimer::singleShot(kMax, &loop, &QEventLoop::quit);
    if (server_.running()) loop.exec(QEventLoop::ExcludeUserInputEvents);
}

void ServerKeeper::stop() {
    asked_ = true;
    session_.send(command::exit(), this, [](const Answer&) {});
    // One that hangs does not listen.
    constexpr int kPatienceMilliseconds = 5000;
    QTimer::singleShot(kPatienceMilliseconds, this, [this, process = server_.process()] {
        if (asked_ && process != 0 && server_.process() == process) server_.stop();
    });
}

bool ServerKeeper::othersUse(const QString& instance) const {
    const bool own = session_.instance() == instance && session_.state() != SessionState::Disconnected;
    return clientsOf(instance, companion_) > (own ? 1 : 0);
}

// A slot that this window had before may still be there: it goes soon after.
bool ServerKeeper::othersStay() {
    const QString& instance = server_.request().instance;
    const bool others = server_.running() && othersUse(instance);
    session_.leave();
    QElapsedTimer clock;
    clock.start();
    constexpr int kPatience = 500, kPause = 5;
    while (others && clientsOf(instance, companion_) > 0) {
        if (clock.hasExpired(kPatience)) return true;
        QThread::msleep(kPause);
    }
    return false;
}

bool ServerKeeper::mayComeBack(const QString& instance) const {
    const bool left = session_.state() == SessionState::Disconnected || session_.instance() != instance;
    return last_.instance == instance && (restarting_ || (canRestart() && !asked_ && !left));
}

void ServerKeeper::restart() {
    const QScopedValueRollback<bool> during(restarting_, true);
    if (session_.lastView().known()) view_ = session_.lastView();
    if (server_.running()) leaveOurs();
    removeLeftovers(last_.instance);
    launch(ServerRequest(last_));
    if (!view_.known()) return; // it never showed anything
    const bool parallel = view_.parallelWidth > 0;
    session_.send(command::camera({.eye = positionOf(view_.eye, view_),
                                   .forward = numbersOf(view_.forward),
                                   .width = parallel ? view_.parallelWidth : view_.fieldOfView,
                                   .orthographic = parallel,
                                   .up = numbersOf(view_.up)}));
    if (view_.walking) session_.send(command::walk());
}

bool ServerKeeper::ours() const {
    return server_.running() && server_.request().instance == session_.instance() &&
           session_.state() != SessionState::Disconnected;
}

void ServerKeeper::keepServers(bool keep) {
    if (std::exchange(keep_, keep) == keep || !ours()) return;
    session_.send(keep ? command::noParent() : command::parent(QCoreApplication::applicationPid()));
}

void ServerKeeper::close() {
    asked_ = true;
    const bool others = othersStay();
    // Otherwise the server ends with its ServerProcess.
    if (keep_ || others) server_.release();
}

void ServerKeeper::onEnded(const QString& text) {
    waitsForFrame_ = false;
    const bool wished = asked_ || text.isEmpty();
    if (session_.state() == SessionState::Connecting && session_.instance() == last_.instance)
        session_.leave();
    if (!wished) emit died(text);
}

void ServerKeeper::onState(SessionState state) {
    const bool ofOurs = session_.instance() == last_.instance && !last_.scene.isEmpty();
    if (state != SessionState::Lost || asked_ || ofOurs) return;
    emit died(tr("The server “%1” has ended.").arg(session_.instance()));
}

} // namespace gui

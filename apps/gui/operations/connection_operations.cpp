#include "gui/operations/connection_operations.h"

#include "gui/dialogs/connect_dialog.h"
#include "gui/dialogs/start_server_dialog.h"
#include "gui/models/bindings.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/processes/programs.h"
#include "gui/processes/server_keeper.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"
#include "gui/view/plain_widgets.h"
#include "gui/view/start_page.h"

#include <QAction>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QPushButton>

#include <utility>

namespace gui {

ConnectionOperations::ConnectionOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    connectActions();
    connect(&context_.actions, &Actions::recentChosen, this, &ConnectionOperations::open);
    connect(&context_.keeper, &ServerKeeper::died, this, &ConnectionOperations::onDeath);
    connect(&context_.keeper, &ServerKeeper::ready, this, &ConnectionOperations::sendBindings);
    connect(&context_.session, &Session::stateChanged, this, &ConnectionOperations::onState);
    connect(&context_.session, &Session::statusChanged, this, [this] {
        context_.actions[ActionId::PauseServer]->setChecked(context_.session.status().paused);
    });
    connect(&context_.session, &Session::commandFailed, this,
            [this](const QString&, const QString& text) { context_.view.tell(text); });
    connect(&context_.preferences, &Preferences::changed, this, &ConnectionOperations::onPreferences);
    addStartPage();
    onPreferences();
    onState();
}

// In the middle of the viewport, while nothing else is there.
void ConnectionOperations::addStartPage() {
    auto* page = new StartPage(exampleScenes(), context_.preferences.recentFiles());
    auto* middle = new QGridLayout(&context_.view);
    middle->addWidget(page, 0, 0, Qt::AlignCenter);
    connect(page, &StartPage::openWanted, this, &ConnectionOperations::open);
    connect(page, &StartPage::chooseWanted, this, &ConnectionOperations::chooseFile);
    connect(page, &StartPage::connectWanted, this, &ConnectionOperations::chooseServer);
    connect(&context_.preferences, &Preferences::changed, page,
            [this, page] { page->setRecent(context_.preferences.recentFiles()); });
    const auto show = [this, page] {
        page->setVisible(context_.session.state() == SessionState::Disconnected && context_.view.showsLive());
    };
    connect(&context_.session, &Session::stateChanged, page, show);
    show();
}

void ConnectionOperations::onPreferences() {
    context_.keeper.keepServers(context_.preferences.get(pref::keepServers));
    context_.keeper.models().setLimit(context_.preferences.get(pref::modelCacheMegabytes));
}

void ConnectionOperations::connectActions() {
    Actions& actions = context_.actions;
    actions.on(ActionId::Open, [this] { chooseFile(); });
    actions.on(ActionId::Exit, [this] { context_.window.close(); });
    actions.on(ActionId::Connect, [this] { chooseServer(); });
    actions.on(ActionId::StartServer, [this] { configureServer(); });
    actions.on(ActionId::Disconnect, [this] { context_.session.leave(); });
    actions.on(ActionId::StopServer, [this] { askToStop(); });
    actions.on(ActionId::PingServer, [this] { ping(); });
    actions.on(ActionId::RestartServer, [this] {
        leaveScene([this] {
            context_.notice.hide();
            context_.keeper.restart();
        });
    });
    actions.onToggle(ActionId::PauseServer,
                     [this](bool on) { context_.session.send(on ? command::pause() : command::resume()); });
}

void ConnectionOperations::chooseFile() {
    const QString folder = context_.preferences.get(pref::sceneFolder);
    auto* dialog = new QFileDialog(&context_.window, tr("Open a scene or a model"), folder, sceneFilter());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &ConnectionOperations::open);
    dialog->open();
}

void ConnectionOperations::open(const QString& path) {
    const QFileInfo file(path);
    const QString suffix = file.suffix().toLower();
    const std::string absolute = file.absoluteFilePath().toStdString();
    std::string line;
    if (suffix == QLatin1String("cam")) line = command::loadCamera(absolute);
    if (suffix == QLatin1String("set")) line = command::loadSet(absolute);
    if (suffix == QLatin1String("lst")) line = command::play(absolute);
    if (line.empty()) return showScene(file.absoluteFilePath());
    if (!context_.session.live()) return context_.view.tell(tr("Open a scene first."));
    context_.session.send(line);
}

QString ConnectionOperations::instanceName() const {
    return instance_.isEmpty() ? context_.preferences.get(pref::instance) : instance_;
}

// Our own server changes its scene; another one belongs to others.
void ConnectionOperations::showScene(const QString& path) {
    leaveScene([this, path] { loadScene(path); });
}

// A server of others keeps its scene, and what is not saved of it.
void ConnectionOperations::leaveScene(const std::function<void()>& go) {
    context_.keeper.ours() && leave_ ? leave_(go) : go();
}

void ConnectionOperations::loadScene(const QString& path) {
    context_.preferences.set(pref::sceneFolder, QFileInfo(path).absolutePath());
    if (!context_.keeper.ours() || !context_.session.live()) {
        ServerRequest request;
        request.scene = path;
        request.instance = instanceName();
        const int frameTime = context_.preferences.get(pref::frameTime);
        if (frameTime > 0) request.options = frameTimeOption(frameTime);
        request.options += std::exchange(startOptions_, {});
        const int percent = context_.preferences.get(pref::pictureScale);
        request.resolution = context_.view.devicePixels() * percent / 100;
        return start(request);
    }
    context_.notice.hide();
    context_.view.tell(tr("Loading %1…").arg(QFileInfo(path).fileName()));
    const QString built = context_.keeper.models().find(path);
    context_.session.send(command::loadScene(path.toStdString(), built.toStdString()), this,
                          [this, path](const Answer& answer) {
                              context_.view.tell({}); // it loads no more
                              if (!answer.done) return context_.notice.explain(answer.text, {});
                              context_.keeper.sceneLoaded(path);
                              context_.editor.refresh(); // a quick load is over before its progress is seen
                              context_.preferences.addRecentFile(path);
                          });
}

void ConnectionOperations::start(const ServerRequest& request) {
    if (!QFileInfo(request.scene).isFile())
        return context_.notice.explain(tr("The file “%1” cannot be read.").arg(request.scene), {});
    context_.notice.hide();
    context_.keeper.start(request);
    context_.preferences.addRecentFile(QFileInfo(request.scene).absoluteFilePath());
}

void ConnectionOperations::chooseServer() {
    auto* dialog = new ConnectDialog(context_.session.instance(), &context_.window);
    connect(dialog, &ConnectDialog::chosen, this, [this](const QString& instance) {
        leaveScene([this, instance] {
            context_.notice.hide();
            context_.keeper.connectTo(instance);
        });
    });
    dialog->open();
}

void ConnectionOperations::configureServer() {
    auto* dialog = new StartServerDialog(context_.preferences, instanceName(), context_.view.devicePixels(),
                                         &context_.window);
    connect(dialog, &StartServerDialog::wanted, this,
            [this](const ServerRequest& request) { leaveScene([this, request] { start(request); }); });
    dialog->open();
}

// Its key is beside those that move.
void ConnectionOperations::askToStop() {
    if (question_ != nullptr) return question_->raise();
    question_ = plainQuestion(
        tr("Stop server"),
        tr("End the server “%1”? All windows connected to it lose it.").arg(context_.session.instance()),
        tr("&Stop"), [this] { context_.keeper.stop(); }, &context_.window);
    question_->open();
}

void ConnectionOperations::ping() {
    auto clock = std::make_shared<QElapsedTimer>();
    clock->start();
    context_.session.send(command::ping(), this, [this, clock](const Answer& answer) {
        constexpr double kMilliseconds = 1e6;
        const double taken = static_cast<double>(clock->nsecsElapsed()) / kMilliseconds;
        context_.view.tell(answer.done
                               ? tr("The server “%1” answered after %2 ms.")
                                     .arg(context_.session.instance(), QLocale().toString(taken, 'f', 1))
                               : answer.text);
    });
}

void ConnectionOperations::onDeath(const QString& text) {
    QList<QAction*> offers;
    if (context_.keeper.canRestart())
        offers = {context_.actions[ActionId::RestartServer], context_.actions[ActionId::ServerLog]};
    context_.notice.explain(text, offers);
}

void ConnectionOperations::onState() {
    context_.actions.setServerThere(context_.session.live());
    context_.actions[ActionId::RestartServer]->setEnabled(context_.keeper.canRestart());
    const SessionState state = context_.session.state();
    const bool explained = state == SessionState::Disconnected || state == SessionState::Refused;
    if (explained && !context_.session.reason().isEmpty())
        context_.notice.explain(context_.session.reason(), {context_.actions[ActionId::StartServer]});
}

// Keys that the user has changed hold on every server that this window started.
void ConnectionOperations::sendBindings() {
    const QString chosen = context_.preferences.get(pref::bindings);
    if (chosen.isEmpty()) return;
    for (const std::string& line : bindingChanges(defaultBindings(), readBindings(chosen)))
        context_.session.send(line);
}

} // namespace gui

#include "gui/operations/connection_operations.h"

#include "gui/dialogs/connect_dialog.h"
#include "gui/dialogs/start_server_dialog.h"
#include "gui/models/bindings.h"
#include "gui/operations/actions.h"
#include "gui/processes/programs.h"
#include "gui/processes/server_keeper.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include <QAction>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace gui {

ConnectionOperations::ConnectionOperations(const Desk& desk, QObject* parent) : QObject(parent), desk_(desk) {
    connectActions();
    connect(&desk_.actions, &Actions::recentChosen, this, &ConnectionOperations::open);
    connect(&desk_.keeper, &ServerKeeper::died, this, &ConnectionOperations::onDeath);
    connect(&desk_.keeper, &ServerKeeper::ready, this, &ConnectionOperations::sendBindings);
    connect(&desk_.session, &Session::stateChanged, this, &ConnectionOperations::onState);
    connect(&desk_.session, &Session::statusChanged, this,
            [this] { desk_.actions[ActionId::PauseServer]->setChecked(desk_.session.status().paused); });
    connect(&desk_.session, &Session::commandFailed, this,
            [this](const QString&, const QString& text) { desk_.view.tell(text); });
    connect(&desk_.preferences, &Preferences::changed, this, &ConnectionOperations::onPreferences);
    onPreferences();
    onState();
}

void ConnectionOperations::onPreferences() {
    desk_.keeper.keepServers(desk_.preferences.get(pref::keepServers));
    desk_.keeper.models().setLimit(desk_.preferences.get(pref::keptModels));
}

void ConnectionOperations::connectActions() {
    Actions& actions = desk_.actions;
    actions.on(ActionId::Open, [this] { chooseFile(); });
    actions.on(ActionId::Exit, [this] { desk_.window.close(); });
    actions.on(ActionId::Connect, [this] { chooseServer(); });
    actions.on(ActionId::StartServer, [this] { configureServer(); });
    actions.on(ActionId::Disconnect, [this] { desk_.session.leave(); });
    actions.on(ActionId::StopServer, [this] { askToStop(); });
    actions.on(ActionId::PingServer, [this] { ping(); });
    actions.on(ActionId::RestartServer, [this] {
        desk_.notice.hide();
        desk_.keeper.restart();
    });
    actions.onToggle(ActionId::PauseServer,
                     [this](bool on) { desk_.session.send(on ? command::pause() : command::resume()); });
}

void ConnectionOperations::chooseFile() {
    const QString folder = desk_.preferences.get(pref::sceneFolder);
    auto* dialog = new QFileDialog(&desk_.window, tr("Open a scene or a model"), folder, sceneFilter());
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
    if (!desk_.session.live()) return desk_.view.tell(tr("Open a scene first."));
    desk_.session.send(line);
}

QString ConnectionOperations::instanceName() const {
    return instance_.isEmpty() ? desk_.preferences.get(pref::instance) : instance_;
}

// Our own server changes its scene; another one belongs to others.
void ConnectionOperations::showScene(const QString& path) {
    desk_.preferences.set(pref::sceneFolder, QFileInfo(path).absolutePath());
    if (!desk_.keeper.ours() || !desk_.session.live()) {
        ServerRequest request;
        request.scene = path;
        request.instance = instanceName();
        const int frameTime = desk_.preferences.get(pref::frameTime);
        if (frameTime > 0) request.options = frameTimeOption(frameTime);
        const int percent = desk_.preferences.get(pref::pictureScale);
        request.resolution = desk_.view.devicePixels() * percent / 100;
        return start(request);
    }
    desk_.notice.hide();
    desk_.view.tell(tr("Loading %1…").arg(QFileInfo(path).fileName()));
    const QString built = desk_.keeper.models().find(path);
    desk_.session.send(command::loadScene(path.toStdString(), built.toStdString()), this,
                       [this, path](const Answer& answer) {
                           desk_.view.tell({}); // it loads no more
                           if (!answer.done) return desk_.notice.explain(answer.text, {});
                           desk_.keeper.sceneLoaded(path);
                           desk_.preferences.addRecentFile(path);
                       });
}

void ConnectionOperations::start(const ServerRequest& request) {
    if (!QFileInfo(request.scene).isFile())
        return desk_.notice.explain(tr("The file “%1” cannot be read.").arg(request.scene), {});
    desk_.notice.hide();
    desk_.keeper.start(request);
    desk_.preferences.addRecentFile(QFileInfo(request.scene).absoluteFilePath());
}

void ConnectionOperations::chooseServer() {
    auto* dialog = new ConnectDialog(desk_.session.instance(), &desk_.window);
    connect(dialog, &ConnectDialog::chosen, this, [this](const QString& instance) {
        desk_.notice.hide();
        desk_.keeper.connectTo(instance);
    });
    dialog->open();
}

void ConnectionOperations::configureServer() {
    auto* dialog =
        new StartServerDialog(desk_.preferences, instanceName(), desk_.view.devicePixels(), &desk_.window);
    connect(dialog, &StartServerDialog::wanted, this, &ConnectionOperations::start);
    dialog->open();
}

// Its key is beside those that move.
void ConnectionOperations::askToStop() {
    if (question_ != nullptr) return question_->raise();
    question_ = new QMessageBox(
        QMessageBox::Question, tr("Stop server"),
        tr("End the server “%1”? Whoever looks at it loses it.").arg(desk_.session.instance()),
        QMessageBox::NoButton, &desk_.window);
    question_->setAttribute(Qt::WA_DeleteOnClose);
    const QPushButton* stop = question_->addButton(tr("&Stop"), QMessageBox::AcceptRole);
    question_->setDefaultButton(question_->addButton(QMessageBox::Cancel));
    connect(stop, &QPushButton::clicked, this, [this] { desk_.keeper.stop(); });
    question_->open();
}

void ConnectionOperations::ping() {
    auto clock = std::make_shared<QElapsedTimer>();
    clock->start();
    desk_.session.send(command::ping(), this, [this, clock](const Answer& answer) {
        constexpr double kMilliseconds = 1e6;
        const double taken = static_cast<double>(clock->nsecsElapsed()) / kMilliseconds;
        desk_.view.tell(answer.done ? tr("The server “%1” answered after %2 ms.")
                                          .arg(desk_.session.instance(), QLocale().toString(taken, 'f', 1))
                                    : answer.text);
    });
}

void ConnectionOperations::onDeath(const QString& text) {
    QList<QAction*> offers;
    if (desk_.keeper.canRestart())
        offers = {desk_.actions[ActionId::RestartServer], desk_.actions[ActionId::ServerLog]};
    desk_.notice.explain(text, offers);
}

void ConnectionOperations::onState() {
    desk_.actions.setServerThere(desk_.session.live());
    desk_.actions[ActionId::RestartServer]->setEnabled(desk_.keeper.canRestart());
    const SessionState state = desk_.session.state();
    const bool explained = state == SessionState::Disconnected || state == SessionState::Refused;
    if (explained && !desk_.session.reason().isEmpty())
        desk_.notice.explain(desk_.session.reason(), {desk_.actions[ActionId::StartServer]});
}

// Keys that the user has changed hold on every server that this window started.
void ConnectionOperations::sendBindings() {
    const QString chosen = desk_.preferences.get(pref::bindings);
    if (chosen.isEmpty()) return;
    for (const std::string& line : bindingChanges(defaultBindings(), readBindings(chosen)))
        desk_.session.send(line);
}

} // namespace gui

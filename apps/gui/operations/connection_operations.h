/// Opening files, and what concerns the server: connect, start, stop, pause, ping, restart, its death.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>
#include <QPointer>
#include <QStringList>

#include <functional>

class QMessageBox;

namespace gui {

struct ServerRequest;

class ConnectionOperations : public QObject {
    Q_OBJECT

  public:
    ConnectionOperations(const GuiContext& context, QObject* parent);

    /// A camera or a file of settings is loaded by the server; anything else is shown, by a server of our
    /// own.
    void open(const QString& path);
    void start(const ServerRequest& request);
    /// Options of the server that the next open() starts.
    void startWith(const QStringList& options) { startOptions_ = options; }
    /// Names the servers of open().
    void setInstance(const QString& instance) { instance_ = instance; }
    QString instanceName() const;
    /// Is asked to go on before another scene takes the place of the one that is shown.
    using Leave = std::function<void(const std::function<void()>& go)>;
    void askBeforeLeaving(const Leave& leave) { leave_ = leave; }

  private:
    void connectActions();
    void addStartPage();
    void onPreferences();
    void chooseFile();
    void chooseServer();
    void configureServer();
    void showScene(const QString& path);
    void loadScene(const QString& path);
    void leaveScene(const std::function<void()>& go);
    void ping();
    void askToStop();
    void onDeath(const QString& text);
    void onState();
    void sendBindings();

    GuiContext context_;
    QString instance_; ///< empty: the preference
    QStringList startOptions_;
    Leave leave_;
    QPointer<QMessageBox> question_;
};

} // namespace gui

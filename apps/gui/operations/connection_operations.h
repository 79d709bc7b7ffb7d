/// Opening files, and what concerns the server: connect, start, stop, pause, ping, restart, its death.
#pragma once

#include "gui/operations/gui_context.h"

#include <QObject>
#include <QPointer>
#include <QStringList>

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

  private:
    void connectActions();
    void addStartPage();
    void onPreferences();
    void chooseFile();
    void chooseServer();
    void configureServer();
    void showScene(const QString& path);
    void ping();
    void askToStop();
    void onDeath(const QString& text);
    void onState();
    void sendBindings();

    GuiContext context_;
    QString instance_; ///< empty: the preference
    QStringList startOptions_;
    QPointer<QMessageBox> question_;
};

} // namespace gui

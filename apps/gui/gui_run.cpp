#include "gui/gui_run.h"

#include "gui/gui_spec.h"
#include "gui/main_window.h"
#include "gui/models/preferences.h"
#include "gui/operations/actions.h"
#include "gui/session/server_list.h"
#include "gui/session/server_sentence.h"
#include "gui/view/language.h"
#include "gui/view/notice_bar.h"

#include "common/process/message.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"

#include "rtcore/platform/error.h"

#include <QAction>
#include <QApplication>
#include <QTimer>

#include <cstdlib>

namespace gui {

namespace {

constexpr int kSignalMilliseconds = 100;

// Qt aborts when there is no screen; that is no crash of ours.
void onQtMessage(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type == QtDebugMsg || type == QtInfoMsg) return;
    app::printMessage(guiSpec().name, text.toStdString());
    if (type != QtFatalMsg) return;
    app::writeError("There is no screen for a window; RTServer and CUI do without one.\n");
    std::_Exit(static_cast<int>(app::ExitCode::Failed));
}

// The error about the file; empty when there is none. A user who starts the program by an icon sees no
// stderr: then the window shows it.
QString troubleWith(const Options& options) {
    try {
        requireFile(options);
        return {};
    } catch (const rtcore::FileError& error) {
        if (app::terminalColumns()) throw;
        app::printMessage(guiSpec().name, error.what());
        return translated(error);
    }
}

} // namespace

app::ExitCode runGui(const app::Arguments& arguments) {
    const Options options = readOptions(arguments);
    const QString trouble = troubleWith(options);
    const QString instance = QString::fromStdString(options.instance);
    if (!instance.isEmpty() && !isInstanceName(instance))
        throw app::UsageError("an instance is 1 to 32 letters, digits, '_' or '-'");
    qInstallMessageHandler(onQtMessage);
    int count = 1;
    std::string name = guiSpec().name;
    char* words[] = {name.data(), nullptr};
    QApplication application(count, words);
    QApplication::setApplicationName(QStringLiteral("GUI"));
    QApplication::setOrganizationName(QStringLiteral("rtsuite"));
    QApplication::setDesktopFileName(QStringLiteral("rtsuite"));

    useLanguage(Preferences().get(pref::language));
    MainWindow window(instance);
    window.show();
    // Once the window has its size: the server draws frames as large.
    QTimer::singleShot(0, &window, [&] {
        if (!trouble.isEmpty()) return window.notice().explain(trouble, {window.actions()[ActionId::Open]});
        QStringList server;
        for (const std::string& each : options.server) server.append(QString::fromStdString(each));
        window.startWith(server);
        if (!options.file.empty()) window.open(QString::fromStdString(options.file));
        if (options.connect) window.connectToServer();
    });
    QTimer stopTimer;
    QObject::connect(&stopTimer, &QTimer::timeout, &window, [&window] {
        if (!app::stopRequested()) return;
        window.close();
        QApplication::quit();
    });
    stopTimer.start(kSignalMilliseconds);
    QApplication::exec();
    return app::stopRequested() ? app::stopExitCode() : app::ExitCode::Done;
}

} // namespace gui

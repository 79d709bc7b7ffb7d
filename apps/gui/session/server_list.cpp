#include "gui/session/server_list.h"

#include "gui/session/preview_reader.h"
#include "gui/session/server_sentence.h"

#include "ipc/endpoint/instances.h"
#include "ipc/endpoint/viewer.h"

#include <QRegularExpression>

#include <algorithm>
#include <chrono>

namespace gui {

namespace {

RunningServer describe(const ipc::Instance& instance) {
    RunningServer server;
    server.instance = QString::fromStdString(instance.name);
    server.process = instance.process;
    server.clients = static_cast<int>(instance.clients.size());
    try {
        ipc::Viewer viewer(instance.name, std::chrono::nanoseconds(0));
        const ipc::Status status = viewer.status();
        server.resolution = QSize(static_cast<int>(status.width), static_cast<int>(status.height));
        server.polygons = status.polygons;
    } catch (const ipc::Error& error) {
        server.trouble = translated(error);
    }
    return server;
}

} // namespace

QList<RunningServer> runningServers() {
    QList<RunningServer> servers;
    for (const ipc::Instance& instance : ipc::listInstances()) {
        const bool preview = QString::fromStdString(instance.name).startsWith(previewPrefix());
        if (instance.running && !preview) servers.append(describe(instance));
    }
    return servers;
}

QString freeInstanceName(const QString& wanted) {
    return QString::fromStdString(ipc::availableName(wanted.toStdString()));
}

bool isInstanceName(const QString& name) {
    static const QRegularExpression pattern(QStringLiteral("\\A[A-Za-z0-9_-]{1,32}\\z"));
    return pattern.match(name).hasMatch();
}

int clientsOf(const QString& instance, qint64 besides) {
    for (const ipc::Instance& each : ipc::listInstances()) {
        if (!each.running || each.name != instance.toStdString()) continue;
        return static_cast<int>(
            std::count_if(each.clients.begin(), each.clients.end(),
                          [besides](qint64 process) { return besides == 0 || process != besides; }));
    }
    return 0;
}

void removeLeftovers(const QString& instance) {
    try {
        ipc::freeInstance(instance.toStdString());
    } catch (const ipc::Error&) {
        return; // it lives, or the next server will do it
    }
}

} // namespace gui

/// Which servers of this user run on this machine.
#pragma once

#include <QList>
#include <QSize>
#include <QString>

namespace gui {

struct RunningServer {
    QString instance;
    qint64 process = 0;
    int clients = 0; ///< windows and other programs that command it
    QSize resolution;
    quint64 polygons = 0;
    QString trouble; ///< why it cannot be connected to; empty when it can
};

/// Sorted by name, without previews. Takes about a millisecond for each server.
QList<RunningServer> runningServers();

/// `wanted` when no server of that name runs, else the name with the first free number behind it.
QString freeInstanceName(const QString& wanted);

/// 1 to 32 letters, digits, '_' and '-'.
bool isInstanceName(const QString& name);

/// Programs that command the server, 0 when there is none; without the clients of the process `besides`.
int clientsOf(const QString& instance, qint64 besides = 0);

/// Removes the shared memory that a dead server left. Does nothing while it lives.
void removeLeftovers(const QString& instance);

} // namespace gui

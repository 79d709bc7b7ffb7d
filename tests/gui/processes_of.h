/// Which processes there are, as Linux tells.
#pragma once

#include <QDir>
#include <QFile>
#include <QList>
#include <QString>
#include <QStringList>

#include <sys/types.h>

namespace test {

struct Child {
    pid_t process = 0;
    bool zombie = false;
};

/// The children of the process whose names begin with `name`.
inline QList<Child> childrenOf(pid_t parent, const QString& name) {
    QList<Child> children;
    for (const QString& entry : QDir(QStringLiteral("/proc")).entryList(QDir::Dirs)) {
        QFile file(QStringLiteral("/proc/%1/stat").arg(entry));
        if (entry[0].isLetter() || !file.open(QIODevice::ReadOnly)) continue;
        const QString text = QString::fromUtf8(file.readAll());
        const QStringList rest = text.section(QLatin1Char(')'), -1).simplified().split(QLatin1Char(' '));
        if (rest.size() < 2 || rest[1].toInt() != parent) continue;
        if (text.section(QLatin1Char('('), 1).startsWith(name))
            children.append({entry.toInt(), rest[0] == QLatin1String("Z")});
    }
    return children;
}
/// A zombie does not.
inline bool runs(pid_t process) {
    QFile file(QStringLiteral("/proc/%1/stat").arg(process));
    return file.open(QIODevice::ReadOnly) &&
           !QString::fromUtf8(file.readAll()).contains(QLatin1String(") Z "));
}

} // namespace test

#include "gui/processes/job.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

namespace gui {

namespace {

QString shellWord(const QString& word) {
    static const QRegularExpression plain(QStringLiteral("^[A-Za-z0-9_+\\-./:=%,@]+$"));
    if (plain.match(word).hasMatch()) return word;
    QString quoted = word;
    quoted.replace(QLatin1Char('\''), QStringLiteral("'\\''"));
    return QLatin1Char('\'') + quoted + QLatin1Char('\'');
}

} // namespace

QString commandText(const QString& program, const QStringList& arguments) {
    QStringList words{shellWord(program)};
    for (const QString& argument : arguments) words.append(shellWord(argument));
    return words.join(QLatin1Char(' '));
}

QString resultFile(const QString& result) {
    const QFileInfo info(result);
    if (result.isEmpty()) return {};
    if (!info.fileName().contains(QLatin1Char('#'))) return info.isFile() ? result : QString();
    static const QRegularExpression run(QStringLiteral("#+(?!.*#)"));
    const QString pattern = info.fileName().replace(run, QStringLiteral("*"));
    const QStringList frames = info.dir().entryList({pattern}, QDir::Files, QDir::Time);
    return frames.isEmpty() ? QString() : info.dir().filePath(frames.first());
}

} // namespace gui

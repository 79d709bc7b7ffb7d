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
    // The last run of # is the number; all else is the name, whatever it means to a pattern.
    const QString name = info.fileName();
    const auto last = name.lastIndexOf(QLatin1Char('#'));
    auto first = last;
    while (first > 0 && name.at(first - 1) == QLatin1Char('#')) --first;
    const QRegularExpression frame(QRegularExpression::anchoredPattern(
        QRegularExpression::escape(name.left(first)) + QStringLiteral("\\d+") +
        QRegularExpression::escape(name.mid(last + 1))));
    for (const QString& each : info.dir().entryList(QDir::Files, QDir::Time)) {
        if (frame.match(each).hasMatch()) return info.dir().filePath(each);
    }
    return {};
}

} // namespace gui

#include "gui/session/printed_lines.h"

#include "gui/session/server_sentence.h"

#include <QProcess>
#include <QStringList>

#include <utility>

namespace gui {

void wantSentences(QProcess& process) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("RT_SENTENCES"), QStringLiteral("1"));
    process.setProcessEnvironment(environment);
}

std::optional<QString> PrintedLines::shown(const QString& line) {
    if (line.startsWith(QChar(0x1E))) {
        const auto said = readSentence(line.mid(1));
        translation_ = said ? translated(*said) : QString();
        return std::nullopt;
    }
    const QString translation = std::exchange(translation_, {});
    const qsizetype name = line.indexOf(QLatin1String(": "));
    return translation.isEmpty() || name < 0 ? line : line.left(name + 2) + translation;
}

QString translatedOutput(const QString& text) {
    PrintedLines lines;
    QStringList all;
    for (const QString& each : text.split(QLatin1Char('\n')))
        if (const auto shown = lines.shown(each)) all.append(*shown);
    return all.join(QLatin1Char('\n'));
}

} // namespace gui

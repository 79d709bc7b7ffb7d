#include "gui/models/messages.h"

#include "gui/models/translated.h"

#include <QHash>
#include <QLocale>
#include <QRegularExpression>

namespace gui {

namespace {

// Warnings that differ only in what they name are of one kind.
QString kindOf(const QString& warning) {
    static const QRegularExpression names(QStringLiteral("'[^']*'|\"[^\"]*\""));
    return QString(warning).replace(names, QStringLiteral("…"));
}

// Quoted names, or the first ones of many.
QString namesText(const QString& names) {
    static const QRegularExpression more(QStringLiteral("^(.*') and (\\d+) more$"));
    static const QRegularExpression two(QStringLiteral("^(.*') and ('[^']*')$"));
    if (const auto found = more.match(names); found.hasMatch())
        return tr("%1 and %2 more").arg(found.captured(1), found.captured(2));
    if (const auto found = two.match(names); found.hasMatch())
        return tr("%1 and %2").arg(found.captured(1), found.captured(2));
    return names;
}

// Without the folders of the file, and in the user's language as far as it is known.
QString warningText(QString warning) {
    static const QRegularExpression folders(QStringLiteral("^/(?:[^:]*/)?(?=[^/:]*: )"));
    static const QRegularExpression missing(
        QStringLiteral("(\\d+) textures are missing, so their materials are plain: (.*)$"));
    static const QRegularExpression one(
        QStringLiteral("texture ('[^']*') is missing; its material is plain$"));
    warning.remove(folders);
    if (const auto found = missing.match(warning); found.hasMatch())
        return warning.left(found.capturedStart()) +
               tr("%1 textures are missing, so their materials are plain: %2")
                   .arg(found.captured(1), namesText(found.captured(2)));
    if (const auto found = one.match(warning); found.hasMatch())
        return warning.left(found.capturedStart()) +
               tr("texture %1 is missing; its material is plain").arg(found.captured(1));
    return warning;
}

// Why something was guessed so.
QString reasonText(const QString& why) {
    static const QRegularExpression files(QStringLiteral("^usual for (.*) files$"));
    if (why == QLatin1String("usual for such files")) return tr("usual for such files");
    if (const auto found = files.match(why); found.hasMatch())
        return tr("usual for %1 files").arg(found.captured(1));
    if (why.startsWith(QLatin1String("usual for "))) return tr("usual for %1").arg(why.mid(10));
    if (why == QLatin1String("by its shape")) return tr("by its shape");
    return why == QLatin1String("by its size") ? tr("by its size") : why;
}

QString countedText(const QString& first, qsizetype count) {
    const QString text = warningText(first);
    return count == 1 ? text : tr("%1 (and others like this: %2)").arg(text, QString::number(count - 1));
}

} // namespace

QList<Message> readMessages(const QString& answer) {
    QList<Message> messages;
    for (const QString& line : answer.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        bool counted = false;
        const quint64 number = line.section(QLatin1Char(' '), 0, 0).toULongLong(&counted);
        const QString kind = line.section(QLatin1Char(' '), 1, 1), text = line.section(QLatin1Char(' '), 2);
        const bool warning = kind == QLatin1String("warning");
        const bool offer = kind == QLatin1String("offer");
        if (counted && (warning || offer || kind == QLatin1String("event")))
            messages.append({number, warning, text, offer});
    }
    return messages;
}

QString eventText(const QString& event) {
    const QStringList words = event.split(QLatin1Char(' '));
    if (event == QLatin1String("walking")) return tr("Walking");
    if (event == QLatin1String("flying")) return tr("Flying");
    if (event.startsWith(QLatin1String("nothing is below")))
        return tr("No floor here: walking on an invisible ground");
    if (event.startsWith(QLatin1String("there is no room to stand")))
        return tr("There is no room to stand here, or no floor below; move elsewhere first.");
    if (event == QLatin1String("bloom on")) return tr("Bloom: on");
    if (event == QLatin1String("bloom off")) return tr("Bloom: off");
    if (words.size() == 3 && words[0] == QLatin1String("light"))
        return (words[2] == QLatin1String("on") ? tr("Light %1: on") : tr("Light %1: off")).arg(words[1]);
    if (words.size() == 2 && words[0] == QLatin1String("environment"))
        return tr("Environment map %1").arg(words[1]);
    if (event.startsWith(QLatin1String("there is no light ")))
        return tr("There is no light %1.").arg(words.last());
    if (event.startsWith(QLatin1String("there is no environment ")))
        return tr("There is no environment map %1.").arg(words.last());
    return event;
}

std::optional<UpOffer> readUpOffer(const QString& offer) {
    static const QRegularExpression form(
        QStringLiteral("^([+-][xyz]) is taken for up \\((.*)\\); 'up ([+-][xyz])' turns the model$"));
    const QRegularExpressionMatch found = form.match(offer);
    if (!found.hasMatch()) return std::nullopt;
    return UpOffer{
        tr("%1 is up (guessed, %2).").arg(found.captured(1).toUpper(), reasonText(found.captured(2))),
        found.captured(3)};
}

std::optional<QString> readUnitOffer(const QString& offer) {
    static const QRegularExpression form(
        QStringLiteral("^([0-9.e+-]+) m are taken for a unit \\((.*)\\); 'units' sets another$"));
    const QRegularExpressionMatch found = form.match(offer);
    if (!found.hasMatch()) return std::nullopt;
    return tr("1 unit = %1 m (guessed, %2).")
        .arg(QLocale().toString(found.captured(1).toDouble(), 'g', 4), reasonText(found.captured(2)));
}

std::optional<QString> readMaterialOffer(const QString& offer) {
    static const QRegularExpression form(
        QStringLiteral("^(\\d+) materials? (?:is|are) guessed by name \\((.*)\\); 'material reset \\*' takes "
                       "them as they are$"));
    const QRegularExpressionMatch found = form.match(offer);
    if (!found.hasMatch()) return std::nullopt;
    const QHash<QString, QString> kinds{
        {QStringLiteral("glass"), tr("glass")},    {QStringLiteral("water"), tr("water")},
        {QStringLiteral("mirror"), tr("mirror")},  {QStringLiteral("chrome"), tr("chrome")},
        {QStringLiteral("metal"), tr("metal")},    {QStringLiteral("polished"), tr("polished")},
        {QStringLiteral("lacquer"), tr("lacquer")}};
    QStringList named;
    for (const QString& kind : found.captured(2).split(QStringLiteral(", ")))
        named.append(kinds.value(kind, kind));
    return tr("Materials guessed by name: %1 (%2).").arg(found.captured(1), named.join(QStringLiteral(", ")));
}

QString warningsText(const QStringList& warnings) {
    QStringList kinds;
    QHash<QString, QStringList> ofKind;
    for (const QString& warning : warnings) {
        const QString kind = kindOf(warning);
        if (!ofKind.contains(kind)) kinds.append(kind);
        ofKind[kind].append(warning);
    }
    constexpr qsizetype kMaxLines = 4;
    QStringList lines;
    for (const QString& kind : kinds.mid(0, kMaxLines))
        lines.append(countedText(ofKind[kind].first(), ofKind[kind].size()));
    const qsizetype more = kinds.size() - lines.size();
    if (more > 0) lines.append(tr("Further warnings: %1").arg(more));
    return lines.join(QLatin1Char('\n'));
}

} // namespace gui

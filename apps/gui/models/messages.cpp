#include "gui/models/messages.h"

#include "gui/models/translated.h"

#include "common/commands/told_forms.h"

#include <QHash>
#include <QLocale>
#include <QRegularExpression>

#include <array>

namespace gui {

namespace {

namespace told = app::told;

// Warnings that differ only in what they name are of one kind.
QString kindOf(const QString& warning) {
    static const QRegularExpression names(QStringLiteral("'[^']*'|\"[^\"]*\""));
    return QString(warning).replace(names, QStringLiteral("…"));
}

// Without the folders of the file.
QString withoutFolder(QString warning) {
    static const QRegularExpression folders(QStringLiteral("^/(?:[^:]*/)?(?=[^/:]*: )"));
    return warning.remove(folders);
}

QString countedText(const QString& first, qsizetype count) {
    const QString text = withoutFolder(first);
    return count == 1 ? text : tr("%1 (and others like this: %2)").arg(text, QString::number(count - 1));
}

// A form that the window shows in words of its own; %1 is the first argument of the form.
struct OwnWords {
    const char *form, *words;
};
constexpr std::array kOwnWords{
    OwnWords{told::kWalking, QT_TRANSLATE_NOOP("gui", "Walking")},
    OwnWords{told::kFlying, QT_TRANSLATE_NOOP("gui", "Flying")},
    OwnWords{told::kUnseenFloor, QT_TRANSLATE_NOOP("gui", "No floor here: walking on an invisible ground")},
    OwnWords{
        told::kNoRoom,
        QT_TRANSLATE_NOOP("gui", "There is no room to stand here, or no floor below; move elsewhere first.")},
    OwnWords{told::kBloomOn, QT_TRANSLATE_NOOP("gui", "Bloom: on")},
    OwnWords{told::kBloomOff, QT_TRANSLATE_NOOP("gui", "Bloom: off")},
    OwnWords{told::kLightOn, QT_TRANSLATE_NOOP("gui", "Light %1: on")},
    OwnWords{told::kLightOff, QT_TRANSLATE_NOOP("gui", "Light %1: off")},
    OwnWords{told::kNoLight, QT_TRANSLATE_NOOP("gui", "There is no light %1.")},
    OwnWords{told::kEnvironment, QT_TRANSLATE_NOOP("gui", "Environment map %1")},
    OwnWords{told::kNoEnvironment, QT_TRANSLATE_NOOP("gui", "There is no environment map %1.")},
};

} // namespace

QString Message::shown() const { return said ? translated(*said) : text; }

QList<Message> readMessages(const QString& answer, const QString& detail) {
    QList<Message> messages;
    const QStringList lines = answer.split(QLatin1Char('\n'));
    const QStringList details = detail.split(QLatin1Char('\n'));
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const QString& line = lines[i];
        bool counted = false;
        const quint64 number = line.section(QLatin1Char(' '), 0, 0).toULongLong(&counted);
        const QString kind = line.section(QLatin1Char(' '), 1, 1), text = line.section(QLatin1Char(' '), 2);
        const bool warning = kind == QLatin1String("warning");
        const bool offer = kind == QLatin1String("offer");
        if (counted && (warning || offer || kind == QLatin1String("event")))
            messages.append({number, warning, text, offer, readSentence(details.value(i))});
    }
    return messages;
}

QString eventText(const Message& event) {
    if (!event.said) return event.text;
    for (const OwnWords& own : kOwnWords) {
        const QString words = tr(own.words);
        if (event.said->form != QLatin1String(own.form)) continue;
        return event.said->arguments.isEmpty() ? words : words.arg(event.said->argument(0));
    }
    return event.shown();
}

std::optional<UpOffer> readUpOffer(const Message& offer) {
    if (!offer.said || offer.said->form != QLatin1String(told::kUpOffer)) return std::nullopt;
    const ServerSentence& said = *offer.said;
    return UpOffer{tr("%1 is up (guessed, %2).").arg(said.argument(0).toUpper(), said.argument(1)),
                   said.argument(2)};
}

std::optional<QString> readUnitOffer(const Message& offer) {
    if (!offer.said || offer.said->form != QLatin1String(told::kUnitOffer)) return std::nullopt;
    return tr("1 unit = %1 m (guessed, %2).")
        .arg(QLocale().toString(offer.said->argument(0).toDouble(), 'g', 4), offer.said->argument(1));
}

std::optional<QString> readMaterialOffer(const Message& offer) {
    if (!offer.said || offer.said->form != QLatin1String(told::kMaterialOffer)) return std::nullopt;
    const ServerSentence guessed = offer.said->arguments.value(0);
    return tr("Materials guessed by name: %1 (%2).").arg(guessed.argument(0), guessed.argument(1));
}

std::optional<FillOffer> readFillOffer(const Message& offer) {
    if (!offer.said || offer.said->form != QLatin1String(told::kFillOffer)) return std::nullopt;
    FillOffer read{
        tr("Indirect light is rendered, and these lights stand in for it: %1.").arg(offer.said->argument(0)),
        {}};
    static const QRegularExpression command(QStringLiteral("light (\\d{1,9}) off"));
    for (auto each = command.globalMatch(offer.said->argument(1)); each.hasNext();)
        read.lights.append(each.next().captured(1).toInt());
    return read;
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

#include "gui/session/server_sentence.h"

#include "common/process/error_sentence.h"

#include "rtcore/io/text/sentence_json.h"
#include "rtcore/platform/sentence.h"

#include <QCoreApplication>

namespace gui {

namespace {

ServerSentence shown(const rtcore::Sentence& sentence) {
    const QString text = QString::fromStdString(sentence.text());
    if (!sentence.isForm()) return {{}, text, {}};
    ServerSentence shownOne{text, {}, {}};
    for (const rtcore::Sentence& each : sentence.arguments()) shownOne.arguments.append(shown(each));
    return shownOne;
}

/// The number of the place that begins at `at`: "{7}"; -1: none does.
int placeAt(const QString& form, qsizetype at) {
    const bool place = at + 2 < form.size() && form[at] == QLatin1Char('{') &&
                       form[at + 2] == QLatin1Char('}') && form[at + 1].isDigit();
    return place ? form[at + 1].digitValue() : -1;
}

} // namespace

QString ServerSentence::argument(qsizetype place) const {
    return place < arguments.size() ? translated(arguments[place]) : QString();
}

const ServerSentence* ServerSentence::find(const char* wanted) const {
    if (form == QLatin1String(wanted)) return this;
    for (const ServerSentence& each : arguments) {
        if (const ServerSentence* const found = each.find(wanted)) return found;
    }
    return nullptr;
}

std::optional<ServerSentence> readSentence(const QString& detail) {
    const auto sentence = rtcore::readSentenceJson(detail.toStdString());
    return sentence && sentence->isForm() ? std::optional(shown(*sentence)) : std::nullopt;
}

QString translated(const ServerSentence& said) {
    if (said.form.isEmpty()) return said.text;
    const QString form = QCoreApplication::translate("Server", said.form.toUtf8().constData());
    QString text;
    for (qsizetype i = 0; i < form.size(); ++i) {
        const int place = placeAt(form, i);
        if (place < 0 || place >= said.arguments.size()) {
            text += form[i];
            continue;
        }
        text += said.argument(place);
        i += 2;
    }
    return text;
}

QString translated(const rtcore::Sentence& said) { return translated(shown(said)); }

QString translated(const std::exception& error) { return translated(app::sentenceOf(error)); }

QString translatedAs(const QString& text, std::span<const char* const> forms) {
    return translated(rtcore::readAs(text.toStdString(), forms));
}

QString serverText(const QString& text, const QString& detail) {
    const auto said = readSentence(detail);
    return said ? translated(*said) : text;
}

} // namespace gui

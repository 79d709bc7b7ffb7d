#include "gui/session/server_sentence.h"

#include "common/commands/sentence_json.h"

#include "rtcore/platform/sentence.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <string>

namespace gui {

namespace {

constexpr int kDeepest = 32;
constexpr qsizetype kLongest = 65'520;

std::optional<ServerSentence> sentenceOf(const QJsonValue& value, int depth) {
    if (value.isString() && depth > 0) return ServerSentence{{}, value.toString(), {}};
    const QJsonArray list = value.toArray();
    if (list.isEmpty() || !list.first().isString() || depth > kDeepest) return std::nullopt;
    ServerSentence sentence{list.first().toString(), {}, {}};
    for (qsizetype i = 1; i < list.size(); ++i) {
        const auto argument = sentenceOf(list.at(i), depth + 1);
        if (!argument) return std::nullopt;
        sentence.arguments.append(*argument);
    }
    return sentence;
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
    if (detail.isEmpty() || detail.size() > kLongest) return std::nullopt;
    const QJsonDocument document = QJsonDocument::fromJson(detail.toUtf8());
    return document.isArray() ? sentenceOf(document.array(), 0) : std::nullopt;
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

QString translatedAs(const QString& text, std::span<const char* const> forms) {
    const std::string english = text.toStdString();
    return serverText(text, QString::fromStdString(app::sentenceJson(rtcore::readAs(english, forms))));
}

QString serverText(const QString& text, const QString& detail) {
    const auto said = readSentence(detail);
    return said ? translated(*said) : text;
}

} // namespace gui

/// Sentences of servers, in the user's language.
#pragma once

#include <QList>
#include <QString>

#include <exception>
#include <optional>
#include <span>

// The header of it is more than moc can read.
namespace rtcore {
class Sentence;
}

namespace gui {

/// As rtcore::Sentence: the form is English, and the key of its translation (translations/sentences_cs.ts).
struct ServerSentence {
    QString form; ///< empty: a text that is the same in every language
    QString text;
    QList<ServerSentence> arguments;

    QString argument(qsizetype place) const; ///< in the user's language
    /// The sentence of this form: itself or an argument, at any depth; null where none has it.
    const ServerSentence* find(const char* wanted) const;
};

/// The sentence in the detail of an answer (rtcore/io/text/sentence_json.h); nothing where there is none.
std::optional<ServerSentence> readSentence(const QString& detail);

/// A form without a translation stays English.
QString translated(const ServerSentence& said);
QString translated(const rtcore::Sentence& said);
/// Errors of shared memory, files and values; what() of others.
QString translated(const std::exception& error);

/// Translates English text that came without a detail, by the forms that may have made it (rtcore::readAs).
QString translatedAs(const QString& text, std::span<const char* const> forms);

/// `text`, or what `detail` says in the user's language.
QString serverText(const QString& text, const QString& detail);

} // namespace gui

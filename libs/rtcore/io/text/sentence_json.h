/// Sentences as they travel between programs: in the detail of an answer (ipc::Reply), from the importer's
/// program.
#pragma once

#include "rtcore/platform/sentence.h"

#include <optional>
#include <string>
#include <string_view>

namespace rtcore {

/// One line of JSON: a list of the form and its arguments, which are texts and lists of the same kind; a text
/// alone where there is no form. Texts are made printable(), so nothing in a name ends a line or a text.
std::string sentenceJson(const Sentence& sentence);

/// Takes any text; nothing where it is no sentence, is longer than 65520 bytes, or nests more than 32 deep.
std::optional<Sentence> readSentenceJson(std::string_view text);

} // namespace rtcore

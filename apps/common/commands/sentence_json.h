/// Sentences as the programs that show them read them: the detail of an answer (ipc::Reply).
#pragma once

#include "rtcore/platform/sentence.h"

#include <string>

namespace app {

/// One line of JSON: a list of the form and of what stands in its places, texts and lists of the same kind;
/// a text alone where there is no form. Texts are rtcore::printable(), so nothing in a name ends a line or a
/// text.
std::string sentenceJson(const rtcore::Sentence& sentence);

} // namespace app

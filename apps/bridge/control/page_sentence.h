/// Sentences for pages, as forms and arguments, so that each page shows them in its own language.
#pragma once

#include "rtcore/platform/sentence.h"

#include <nlohmann/json_fwd.hpp>

#include <string_view>

namespace bridge {

/// Sets `text` of an event, in English, and `sentence`, where there is one: a list of the form and of what
/// stands in its places, texts and lists of the same kind. Both are withoutFolders(). `detail` is a server's
/// (rtcore/io/text/sentence_json.h); what is none, or too long, is left out.
void addSentence(nlohmann::json& event, std::string_view text, std::string_view detail);
/// The same of a sentence of the bridge.
void addSentence(nlohmann::json& event, const rtcore::Sentence& said);

} // namespace bridge

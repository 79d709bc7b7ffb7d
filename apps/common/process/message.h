/// Messages of a program to the people who run it.
#pragma once

#include "rtcore/platform/sentence.h"

#include <string_view>

namespace app {

/// "Program: text" and a line end, on stderr, in one write. Names in the text may come from anywhere: control
/// characters and what is no UTF-8 are shown as `\xNN`. Safe from any thread.
void printMessage(std::string_view program, std::string_view text) noexcept;

/// The same for a sentence. Where the environment has RT_SENTENCES=1, a line before it has the sentence in
/// JSON (rtcore/io/text/sentence_json.h) behind the control character RS, as RFC 7464 begins a record: for
/// who started the program and shows what it says in another language. No name can forge such a line.
void printSentence(std::string_view program, const rtcore::Sentence& said) noexcept;
/// The same for a form without places, which takes no memory before it.
void printForm(std::string_view program, const char* form) noexcept;

} // namespace app

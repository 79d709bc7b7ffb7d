/// Commands between programs are lines of words: blanks part them, double quotes hold a word with blanks
/// together, and a backslash takes the next character as it is.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Throws UsageError when a quote is not closed or the text ends with a backslash.
std::vector<std::string> splitWords(std::string_view text);

/// The text that splitWords() takes apart into these words.
std::string joinWords(std::span<const std::string> words);

} // namespace app

/// Completions for shells: the script packaging/completion.bash.in asks for them when Tab is pressed.
#pragma once

#include "common/cli/options.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// `Program --complete WORD...` answers what may stand for the last WORD; what comes before it has been
/// typed.
inline constexpr std::string_view kCompleteOption = "--complete";

/// The answer. Words are whole words and begin with what is there already.
struct Completion {
    std::vector<std::string> words;      ///< one that ends with '=' goes on
    bool files = false;                  ///< files and folders, too
    std::size_t prefix = 0;              ///< bytes of the last word before the name of the file
    std::vector<std::string> extensions; ///< usual ones of the files; none = any
    std::string program;                 ///< ask this one, about the words from `first` on, for options only
    std::size_t first = 0;
};

/// `words` are those after the program's name; the last one may be empty. `spec` without --help and
/// --version, which are added.
Completion completeWords(const ProgramSpec& spec, std::span<const std::string> words);

/// As the script reads it, one a line: "word WORD", "files PREFIX EXTENSION...", "program NAME FIRST".
std::string completionText(const Completion& completion);

} // namespace app

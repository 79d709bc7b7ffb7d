/// The spellings of options, and the labels of commands taken apart.
#pragma once

#include "common/cli/options.h"

#include <string>
#include <string_view>
#include <vector>

namespace app {

/// "-a", "-aon", "--antialiasing": all, with their dashes.
std::vector<std::string> optionSpellings(const Option& option);

/// "light N on|off": the words that name the command, then what may stand in each place after them.
struct CommandLabel {
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> places; ///< alternatives; "--" alone is one, too
    bool repeats = false;                         ///< the last place stands for any number of words

    std::string command() const; ///< the names, a blank between them
};
CommandLabel parseCommandLabel(std::string_view label);

/// Whether it stands for something ("FILE"), not for itself ("on", "-").
bool isPlaceholder(std::string_view text);

} // namespace app

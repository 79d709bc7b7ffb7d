#include "cui/argument_order.h"

#include "common/cli/command_line.h"
#include "common/cli/completion.h"

#include <algorithm>

namespace cui {

namespace {

bool isOption(const std::string& word) {
    return word.size() > 1 && word.front() == '-' && !app::parseNumber(word);
}

// Whether the word after this one is its value.
bool takesNextWord(const app::ProgramSpec& spec, const std::string& word) {
    for (const app::OptionGroup& group : spec.groups) {
        for (const app::Option& option : group.options) {
            const bool named = word == "--" + option.name;
            const bool lettered = option.letter != 0 && word == std::string("-") + option.letter;
            if (named || lettered) return option.value != app::ValueKind::None;
        }
    }
    return false;
}

} // namespace

std::vector<std::string> optionsFirst(const app::ProgramSpec& spec, const std::vector<std::string>& words) {
    if (!words.empty() && words.front() == app::kCompleteOption) return words;
    std::vector<std::string> options, others;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--") {
            others.insert(others.end(), words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words.end());
            break;
        }
        if (!isOption(words[i])) {
            others.push_back(words[i]);
            continue;
        }
        options.push_back(words[i]);
        if (takesNextWord(spec, words[i]) && i + 1 < words.size()) options.push_back(words[++i]);
    }
    if (!others.empty()) options.emplace_back("--");
    options.insert(options.end(), others.begin(), others.end());
    return options;
}

} // namespace cui

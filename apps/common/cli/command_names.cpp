#include "common/cli/command_names.h"

#include <algorithm>
#include <sstream>

namespace app {

namespace {

std::vector<std::string> alternatives(const std::string& token) {
    std::vector<std::string> result;
    std::istringstream parts(token);
    for (std::string part; std::getline(parts, part, '|');) result.push_back(part);
    return result;
}

bool isName(const std::string& token) {
    return token.find('|') == std::string::npos && !isPlaceholder(token) && token.front() != '-';
}

} // namespace

std::vector<std::string> optionSpellings(const Option& option) {
    std::vector<std::string> all;
    if (option.letter != 0) all.push_back(std::string("-") + option.letter);
    all.insert(all.end(), option.thesis.begin(), option.thesis.end());
    all.push_back("--" + option.name);
    return all;
}

bool isPlaceholder(std::string_view text) {
    return !text.empty() && text.front() >= 'A' && text.front() <= 'Z';
}

std::string CommandLabel::command() const {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
    return text;
}

CommandLabel parseCommandLabel(std::string_view label) {
    CommandLabel result;
    std::istringstream tokens{std::string(label)};
    for (std::string token; tokens >> token;) {
        const bool optional = token.starts_with('[');
        std::erase_if(token, [](char c) { return c == '[' || c == ']'; });
        result.repeats = token.ends_with("...");
        if (result.repeats) token.resize(token.size() - 3);
        if (token.empty()) continue;
        if (result.places.empty() && !optional && isName(token)) {
            result.names.push_back(token);
        } else {
            result.places.push_back(alternatives(token));
        }
    }
    return result;
}

} // namespace app

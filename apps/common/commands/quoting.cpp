#include "common/commands/quoting.h"

#include "common/cli/command_line.h"

#include <optional>

namespace app {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

bool isBlank(char c) { return kBlanks.find(c) != std::string_view::npos; }

bool needsQuotes(std::string_view word) {
    return word.empty() || word.find_first_of(" \t\r\n\"\\") != std::string_view::npos;
}

} // namespace

std::vector<std::string> splitWords(std::string_view text) {
    std::vector<std::string> words;
    std::optional<std::string> word;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (isBlank(c) && !quoted) {
            if (word) words.push_back(*word);
            word.reset();
            continue;
        }
        if (!word) word.emplace();
        if (c == '"') {
            quoted = !quoted;
        } else if (c != '\\') {
            *word += c;
        } else if (++i < text.size()) {
            *word += text[i];
        } else {
            throw UsageError("the command ends with a backslash");
        }
    }
    if (quoted) throw UsageError("a quotation mark is not closed");
    if (word) words.push_back(*word);
    return words;
}

std::string joinWords(std::span<const std::string> words) {
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += ' ';
        if (!needsQuotes(word)) {
            text += word;
            continue;
        }
        text += '"';
        for (const char c : word) {
            if (c == '"' || c == '\\') text += '\\';
            text += c;
        }
        text += '"';
    }
    return text;
}

} // namespace app

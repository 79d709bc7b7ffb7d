#include "rtcore/io/text/sentence_json.h"

#include "rtcore/settings/plain_text.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace rtcore {

namespace {

using SentenceData = nlohmann::json;

constexpr int kDeepest = 32;
constexpr std::size_t kLongest = 65'520;

SentenceData dataOf(const Sentence& sentence) {
    if (!sentence.isForm()) return printable(sentence.text());
    SentenceData data = SentenceData::array({printable(sentence.text())});
    for (const Sentence& each : sentence.arguments()) data.push_back(dataOf(each));
    return data;
}

std::optional<Sentence> readData(const SentenceData& data, int depth) {
    if (data.is_string()) return Sentence(data.get<std::string>());
    if (!data.is_array() || data.empty() || !data[0].is_string() || depth > kDeepest) return std::nullopt;
    std::vector<Sentence> arguments;
    for (std::size_t i = 1; i < data.size(); ++i) {
        auto argument = readData(data[i], depth + 1);
        if (!argument) return std::nullopt;
        arguments.push_back(std::move(*argument));
    }
    return Sentence(data[0].get<std::string>().c_str(), std::move(arguments));
}

/// Deeper brackets than any sentence has, on which a recursive parser could spend its stack.
bool nestsTooDeep(std::string_view text) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (quoted && text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            quoted = !quoted;
        else if (!quoted && text[i] == '[' && ++depth > kDeepest)
            return true;
        else if (!quoted && text[i] == ']')
            --depth;
    }
    return false;
}

} // namespace

std::string sentenceJson(const Sentence& sentence) {
    // The library throws for what is no UTF-8 to it; messages are told by functions that must not.
    return dataOf(sentence).dump(-1, ' ', false, SentenceData::error_handler_t::replace);
}

std::optional<Sentence> readSentenceJson(std::string_view text) {
    if (text.empty() || text.size() > kLongest || nestsTooDeep(text)) return std::nullopt;
    const SentenceData data = SentenceData::parse(text, nullptr, false);
    return data.is_discarded() ? std::nullopt : readData(data, 0);
}

} // namespace rtcore

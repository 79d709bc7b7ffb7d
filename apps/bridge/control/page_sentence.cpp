#include "bridge/control/page_sentence.h"

#include "bridge/control/scene_facts.h"

#include "rtcore/io/text/sentence_json.h"
#include "rtcore/platform/sentence.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace bridge {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestDetail = 16'000; ///< bytes
constexpr int kDeepest = 32;

/// Whether `value` is a sentence; its texts are withoutFolders() then. Names stand in arguments alone.
bool takeSentence(json& value, int depth = 0) {
    if (value.is_string()) {
        if (depth > 0) value = withoutFolders(value.get_ref<const std::string&>());
        return depth > 0;
    }
    if (!value.is_array() || value.empty() || !value.front().is_string() || depth > kDeepest) return false;
    return std::all_of(value.begin() + 1, value.end(),
                       [&](json& argument) { return takeSentence(argument, depth + 1); });
}

} // namespace

void addSentence(json& event, std::string_view text, std::string_view detail) {
    event["text"] = withoutFolders(text);
    if (detail.empty() || detail.size() > kLongestDetail) return;
    json sentence = json::parse(detail, nullptr, false);
    if (takeSentence(sentence)) event["sentence"] = std::move(sentence);
}

void addSentence(json& event, const rtcore::Sentence& said) {
    addSentence(event, said.english(), said.isForm() ? rtcore::sentenceJson(said) : "");
}

} // namespace bridge

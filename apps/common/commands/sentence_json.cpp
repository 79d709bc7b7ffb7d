#include "common/commands/sentence_json.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

namespace app {

namespace {

void addText(const std::string& text, std::string& json) {
    json += '"';
    for (const char c : rtcore::printable(text)) {
        if (c == '"' || c == '\\') json += '\\';
        json += c;
    }
    json += '"';
}

void add(const rtcore::Sentence& sentence, std::string& json) {
    if (!sentence.isForm()) return addText(sentence.text(), json);
    json += '[';
    addText(sentence.text(), json);
    for (const rtcore::Sentence& each : sentence.arguments()) {
        json += ',';
        add(each, json);
    }
    json += ']';
}

} // namespace

std::string sentenceJson(const rtcore::Sentence& sentence) {
    std::string json;
    add(sentence, json);
    return json;
}

} // namespace app

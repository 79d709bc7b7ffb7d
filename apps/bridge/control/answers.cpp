// Answers of the server, as pages get them.
#include "bridge/control/requests.h"

#include "common/cli/command_line.h"

#include "rtcore/io/text/toml_parser.h"

#include <nlohmann/json.hpp>

#include <string_view>

namespace bridge {

namespace {

using nlohmann::json;

/// The first word of `line`, which is cut off it.
std::string_view takeWord(std::string_view& line) {
    const std::size_t end = std::min(line.find(' '), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    return word;
}

template <typename Use>
void eachLine(std::string_view text, Use&& use) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        use(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

json partJson(std::string_view line) {
    const auto number = app::parseInteger(takeWord(line));
    const bool shown = takeWord(line) == "shown";
    const auto triangles = app::parseInteger(takeWord(line));
    if (!number || !triangles) return {};
    return {{"number", *number}, {"shown", shown}, {"triangles", *triangles}, {"name", line}};
}

json materialRow(std::string_view line) {
    const auto number = app::parseInteger(takeWord(line));
    const bool edited = takeWord(line) == "edited";
    if (!number) return {};
    return {{"number", *number}, {"edited", edited}, {"name", line}};
}

/// `next` only where the answer was so long that more may follow.
json listJson(const char* key, const std::string& text, json (*row)(std::string_view)) {
    constexpr std::size_t kFull = 64000; // of 65,520 bytes, which whole lines do not fill
    json rows = json::array();
    eachLine(text, [&](std::string_view line) {
        json each = row(line);
        if (!each.is_null()) rows.push_back(std::move(each));
    });
    json content{{key, rows}};
    if (text.size() > kFull && !rows.empty()) content["next"] = rows.back()["number"].get<std::int64_t>() + 1;
    return content;
}

json tomlJson(const rtcore::TextValue& value) {
    if (const auto* flag = std::get_if<bool>(&value.content)) return *flag;
    if (const auto* whole = std::get_if<std::int64_t>(&value.content)) return *whole;
    if (const auto* number = std::get_if<double>(&value.content)) return *number;
    if (const auto* text = std::get_if<std::string>(&value.content)) return *text;
    json list = json::array();
    if (const auto* array = std::get_if<rtcore::TextArray>(&value.content))
        for (const rtcore::TextValue& each : *array) list.push_back(tomlJson(each));
    return list;
}

const rtcore::TextTable* firstTable(const rtcore::TextValue& root) {
    const auto* const table = std::get_if<rtcore::TextTable>(&root.content);
    if (table == nullptr) return nullptr;
    for (const rtcore::TextEntry& entry : table->entries) {
        const auto* const list = std::get_if<rtcore::TextArray>(&entry.value.content);
        if (list != nullptr && !list->empty()) return std::get_if<rtcore::TextTable>(&list->front().content);
    }
    return nullptr;
}

json materialJson(const std::string& text) {
    const rtcore::TextValue root = rtcore::parseToml(text, "the server's answer");
    json keys = json::object();
    if (const rtcore::TextTable* const table = firstTable(root))
        for (const rtcore::TextEntry& entry : table->entries)
            if (entry.key != "diffuseTexture") keys[entry.key] = tomlJson(entry.value); // a path
    return {{"material", keys}};
}

json seenJson(const std::string& text) {
    json content = json::object();
    eachLine(text, [&](std::string_view line) {
        const std::string_view what = takeWord(line);
        const auto number = app::parseInteger(takeWord(line));
        if (number && (what == "part" || what == "material"))
            content[std::string(what)] = {{"number", *number}, {"name", line}};
    });
    return content;
}

} // namespace

json answerContent(app::CommandId id, const std::string& text) {
    using enum app::CommandId;
    try {
        switch (id) {
        case LightAdd:
        case LightCopy:
            if (const auto light = app::parseInteger(text)) return {{"light", *light}};
            break;
        case Parts:
            return listJson("parts", text, partJson);
        case Materials:
            return listJson("materials", text, materialRow);
        case MaterialGet:
            return materialJson(text);
        case NoteList:
            return {{"notes", text}};
        case NoteGet:
            return {{"note", text}};
        case Seen:
            return seenJson(text);
        default:
            break;
        }
    } catch (const std::exception&) { // not what was expected
    }
    return json::object();
}

} // namespace bridge

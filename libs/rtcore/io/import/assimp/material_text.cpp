#include "rtcore/io/import/assimp/material_text.h"

#include "rtcore/io/import/assimp/unread_content.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

namespace rtcore {

namespace {

using View = std::string_view;

std::string lowered(View text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::string contentOf(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

View withoutBlanks(View text) {
    constexpr View kBlanks = " \t\r";
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// Takes the first word off `line`.
View takeWord(View& line) {
    line = withoutBlanks(line);
    const View word = line.substr(0, line.find_first_of(" \t"));
    line.remove_prefix(word.size());
    return word;
}

std::optional<float> numberIn(View word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    float value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

/// Up to three numbers; those behind the first need not be there.
Vec2 takeVector(View& line, Vec2 otherwise) {
    Vec2 v = otherwise;
    for (int i = 0; i < 3; ++i) {
        View rest = line;
        const auto number = numberIn(takeWord(rest));
        if (!number) break;
        if (i == 0) v.x = *number;
        if (i == 1) v.y = *number;
        line = rest;
    }
    return v;
}

/// Parses the options before a name; `rest` gets those that Assimp is to see, and the name.
MapOptions optionsIn(View line, std::string& rest) {
    MapOptions options;
    for (line = withoutBlanks(line); line.starts_with('-'); line = withoutBlanks(line)) {
        const View word = takeWord(line);
        const std::string option = lowered(word);
        if (option == "-s") {
            options.scale = takeVector(line, options.scale);
        } else if (option == "-o") {
            options.offset = takeVector(line, options.offset);
        } else if (option == "-t") {
            takeVector(line, {});
        } else if (option == "-mm") {
            takeWord(line);
            takeWord(line);
        } else {
            const View value = takeWord(line);
            if (option == "-bm") options.bump = numberIn(value).value_or(1.0F);
            rest.append(" ").append(word).append(" ").append(value);
        }
    }
    rest.append(" ").append(line);
    return options;
}

View takeLine(View& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const View line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

std::optional<MapUse> useOf(const std::string& statement) {
    using Row = std::pair<View, MapUse>;
    static constexpr std::array kStatements{
        Row{"map_kd", MapUse::Diffuse},  Row{"map_d", MapUse::Opacity},
        Row{"map_kn", MapUse::Normal},   Row{"norm", MapUse::Normal},
        Row{"map_ke", MapUse::Emission}, Row{"map_emissive", MapUse::Emission},
        Row{"map_bump", MapUse::Height}, Row{"bump", MapUse::Height},
        Row{"map_ks", MapUse::Specular}};
    for (const auto& [word, use] : kStatements)
        if (statement == word) return use;
    return std::nullopt;
}

void readMtl(View text, std::map<std::string, MaterialText>& materials) {
    MaterialText* material = nullptr;
    while (!text.empty()) {
        View line = takeLine(text);
        const std::string statement = lowered(takeWord(line));
        if (statement == "newmtl") material = &materials[std::string(withoutBlanks(line))];
        const auto use = useOf(statement);
        std::string rest;
        if (material != nullptr && use) material->optionsOf(*use) = optionsIn(line, rest);
    }
}

/// An element of XML.
struct Element {
    View head; ///< with its attributes
    View body;
};

/// The next element of this name in `text`, which is cut behind it. Elements do not hold others of their
/// name.
std::optional<Element> takeElement(View& text, const std::string& name) {
    const std::string begin = "<" + name, end = "</" + name + ">";
    for (std::size_t at = text.find(begin); at != View::npos; at = text.find(begin, at + 1)) {
        const std::size_t behind = at + begin.size();
        if (behind >= text.size() || View(" \t\r\n/>").find(text[behind]) == View::npos) continue;
        const std::size_t close = text.find('>', behind);
        if (close == View::npos) break;
        Element element{text.substr(at, close - at), {}};
        std::size_t last = close + 1;
        if (!element.head.ends_with('/')) {
            last = std::min(text.find(end, close), text.size());
            element.body = text.substr(close + 1, last - close - 1);
        }
        text.remove_prefix(last);
        return element;
    }
    text = {};
    return std::nullopt;
}

std::string attributeOf(View head, const std::string& name) {
    for (const char quote : {'"', '\''}) {
        const std::string begin = " " + name + "=" + quote;
        const std::size_t at = head.find(begin);
        if (at == View::npos) continue;
        const View value = head.substr(at + begin.size());
        return std::string(value.substr(0, value.find(quote)));
    }
    return {};
}

SpecularOrigin specularOf(View effect) {
    View rest = effect;
    if (takeElement(rest, "lambert")) return SpecularOrigin::None;
    rest = effect;
    if (takeElement(rest, "constant")) return SpecularOrigin::Stated;
    const auto specular = takeElement(effect, "specular");
    if (!specular) return SpecularOrigin::None;
    const auto holds = [&](const char* what) { return specular->body.find(what) != View::npos; };
    if (holds("<color") || holds("<param")) return SpecularOrigin::Stated;
    return holds("<texture") ? SpecularOrigin::Texture : SpecularOrigin::None;
}

std::string withoutComments(std::string text) {
    for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at)) {
        const std::size_t end = text.find("-->", at);
        text.erase(at, end == std::string::npos ? end : end + 3 - at);
    }
    return text;
}

/// In the order of their identifiers, those alone whose effect is there.
std::vector<MaterialText> colladaMaterials(const std::filesystem::path& path) {
    const std::string text = withoutComments(contentOf(path));
    std::map<std::string, SpecularOrigin> effects, materials;
    View rest = text;
    while (const auto effect = takeElement(rest, "effect"))
        effects[attributeOf(effect->head, "id")] = specularOf(effect->body);
    rest = text;
    while (const auto material = takeElement(rest, "material")) {
        View body = material->body;
        const auto instance = takeElement(body, "instance_effect");
        if (!instance) continue;
        const std::string url = attributeOf(instance->head, "url");
        const auto effect = effects.find(url.substr(std::min<std::size_t>(1, url.size())));
        if (effect != effects.end()) materials[attributeOf(material->head, "id")] = effect->second;
    }
    std::vector<MaterialText> inOrder;
    for (const auto& [id, specular] : materials) inOrder.push_back({specular, {}});
    return inOrder;
}

} // namespace

MaterialTexts::MaterialTexts(const std::filesystem::path& path) {
    for (const auto& library : materialLibraries(path)) readMtl(contentOf(library), byName_);
    if (lowered(path.extension().string()) == ".dae") inOrder_ = colladaMaterials(path);
}

MaterialText MaterialTexts::of(const std::string& name, std::size_t index, std::size_t count) const {
    if (inOrder_.size() == count && index < count) return inOrder_[index];
    const auto named = byName_.find(name);
    return named != byName_.end() ? named->second : MaterialText{};
}

std::string withoutMapOptions(std::string_view mtl) {
    std::string text;
    while (!mtl.empty()) {
        const View line = takeLine(mtl);
        View options = line;
        const View statement = takeWord(options);
        if (useOf(lowered(statement))) {
            text += statement;
            optionsIn(options, text);
        } else {
            text += line;
        }
        text += '\n';
    }
    return text;
}

} // namespace rtcore

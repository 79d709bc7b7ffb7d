#include "rtcore/io/import/assimp/material_text.h"

#include "rtcore/platform/files.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <string>
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
    for (const auto& [id, specular] : materials) inOrder.push_back({specular});
    return inOrder;
}

} // namespace

MaterialTexts::MaterialTexts(const std::filesystem::path& path) {
    if (lowered(path.extension().string()) == ".dae") inOrder_ = colladaMaterials(path);
}

MaterialText MaterialTexts::of(std::size_t index, std::size_t count) const {
    return inOrder_.size() == count && index < count ? inOrder_[index] : MaterialText{};
}

} // namespace rtcore

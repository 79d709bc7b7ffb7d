#include "rtcore/io/import/assimp/xml_text.h"

#include "rtcore/io/import/assimp/xml_tree.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <cctype>

namespace rtcore::xml {

namespace {
using View = std::string_view;
} // namespace

std::optional<Element> takeElement(View& text, const std::string& name) {
    const std::string begin = "<" + name, end = "</" + name + ">";
    for (std::size_t at = text.find(begin); at != View::npos; at = text.find(begin, at + 1)) {
        const std::size_t behind = at + begin.size();
        if (behind >= text.size() || View(" \t\r\n/>").find(text[behind]) == View::npos) continue;
        const std::size_t close = endOfHead(text, at);
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

View valueOf(const Element& element, View name) {
    View attributes =
        element.head.substr(std::min(element.head.find_first_of(" \t\r\n"), element.head.size()));
    while (const auto attribute = takeAttribute(attributes))
        if (attribute->name == name) return attribute->value;
    return {};
}

std::string idOf(const std::string& url) { return url.substr(std::min<std::size_t>(1, url.size())); }

std::string textWithoutComments(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    std::string text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
    for (std::size_t at = text.find("<!--"); at != std::string::npos; at = text.find("<!--", at)) {
        const std::size_t end = text.find("-->", at);
        text.erase(at, end == std::string::npos ? end : end + 3 - at);
    }
    return text;
}

bool isCollada(const std::filesystem::path& path) {
    std::string own = path.extension().string();
    std::transform(own.begin(), own.end(), own.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return own == ".dae";
}

} // namespace rtcore::xml

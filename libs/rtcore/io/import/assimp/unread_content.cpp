#include "rtcore/io/import/assimp/unread_content.h"

#include "rtcore/io/import/assimp/xml_text.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/platform/files.h"

#include <string_view>

namespace rtcore {

namespace {

std::string_view textOf(const FileBytes& file) {
    return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

} // namespace

std::vector<const char*> unreadInCollada(const std::filesystem::path& path) {
    if (!xml::isCollada(path)) return {};
    const FileBytes file = openFileBytes(path);
    const std::string_view text = textOf(file);
    const auto has = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
    std::vector<const char*> sentences;
    const bool ends =
        has("<wrap_s>CLAMP") || has("<wrap_t>CLAMP") || has("<wrap_s>MIRROR") || has("<wrap_t>MIRROR");
    if (ends) sentences.push_back(import_forms::kWrapped);
    if (has("<orthographic>")) sentences.push_back(import_forms::kOrthographic);
    return sentences;
}

} // namespace rtcore

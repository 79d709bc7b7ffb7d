#include "rtcore/io/import/assimp/unread_content.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace rtcore {

namespace {

bool hasEnding(const std::filesystem::path& path, const char* ending) {
    std::string own = path.extension().string();
    std::transform(own.begin(), own.end(), own.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return own == ending;
}

std::string_view textOf(const FileBytes& file) {
    return {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()};
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r";
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// The names behind `mtllib` at the beginning of lines, each once.
std::vector<std::string> librariesIn(std::string_view text) {
    constexpr std::string_view kWord = "mtllib";
    std::vector<std::string> names;
    for (std::size_t at = text.find(kWord); at != std::string_view::npos; at = text.find(kWord, at)) {
        const bool begins = trimmed(text.substr(0, at).substr(text.substr(0, at).rfind('\n') + 1)).empty();
        at += kWord.size();
        const std::string name(trimmed(text.substr(at, text.find('\n', at) - at)));
        if (begins && !name.empty() && std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    }
    return names;
}

} // namespace

std::vector<std::string> missingMaterialLibraries(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    if (!hasEnding(path, ".obj")) return {};
    std::vector<std::string> names = librariesIn(textOf(openFileBytes(path)));
    std::error_code error;
    if (fs::exists(fs::path(path).replace_extension(".mtl"), error)) return {};
    std::erase_if(names,
                  [&](const std::string& name) { return fs::exists(path.parent_path() / name, error); });
    return names;
}

std::vector<std::filesystem::path> materialLibraries(const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    if (!hasEnding(path, ".obj")) return {};
    std::vector<fs::path> found;
    std::error_code error;
    for (const std::string& name : librariesIn(textOf(openFileBytes(path)))) {
        fs::path library = path.parent_path() / name;
        if (!fs::is_regular_file(library, error)) library = fs::path(path).replace_extension(".mtl");
        if (fs::is_regular_file(library, error)) found.push_back(std::move(library));
    }
    return found;
}

std::vector<const char*> unreadInCollada(const std::filesystem::path& path) {
    if (!hasEnding(path, ".dae")) return {};
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

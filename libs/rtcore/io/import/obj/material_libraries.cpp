#include "rtcore/io/import/obj/material_libraries.h"

#include "rtcore/io/import/materials/texture_files.h"
#include "rtcore/io/import/text/statement_text.h"

#include <algorithm>

namespace rtcore {

namespace {

namespace fs = std::filesystem;

/// A path is no longer, nor are there more names in a statement.
constexpr std::size_t kLongest = 4096, kMaxNames = 256;

void addName(std::vector<std::string>& names, std::string_view name) {
    if (std::ranges::find(names, name) == names.end() && names.size() < kMaxNames) names.emplace_back(name);
}

/// The ends of the words in `text`, longest first, of which the first name may be made; a quoted one is one
/// word.
std::vector<std::size_t> endsOfWords(std::string_view text) {
    constexpr std::size_t kMaxWords = 32; // in a name
    if (text.starts_with('"') && text.find('"', 1) != std::string_view::npos) return {text.find('"', 1) + 1};
    std::vector<std::size_t> ends;
    for (std::size_t at = 0; at < text.size() && ends.size() < kMaxWords;) {
        const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
        ends.push_back(end);
        at = std::min(text.find_first_not_of(" \t", end), text.size());
    }
    std::ranges::reverse(ends);
    return ends;
}

} // namespace

LibraryFinder::LibraryFinder(const fs::path& model)
    : folder_(model.parent_path()), home_(model), namesake_(model.filename().replace_extension(".mtl")) {}

std::optional<MaterialLibrary> LibraryFinder::findOne(std::string_view name, bool& isOutside) const {
    std::string spelled(unquoted(name));
    spelled = spelled.substr(0, spelled.find('\0'));
    std::ranges::replace(spelled, '\\', '/');
    if (spelled.empty() || spelled.size() > kLongest) return std::nullopt;
    std::vector<fs::path> tried = shorterPaths(spelled);
    tried.insert(tried.begin(), spelled);
    for (const fs::path& path : tried) {
        const auto file = fileOfAnyCase(folder_, path);
        if (!file) continue;
        if (!home_.holds(*file)) {
            isOutside = true;
            continue;
        }
        const fs::path within = path.is_relative() ? path.parent_path() : fs::path();
        return MaterialLibrary{*file, within.empty() ? "" : within.generic_string() + "/"};
    }
    return std::nullopt;
}

void LibraryFinder::findSeveral(std::string_view names, Search& to) const {
    for (std::size_t count = 0; !names.empty() && count < kMaxNames; ++count) {
        const std::vector<std::size_t> ends = endsOfWords(names);
        std::size_t length = ends.back();
        bool isOutside = false;
        std::optional<MaterialLibrary> library;
        for (std::size_t i = 0; i < ends.size() && !library; ++i) {
            library = findOne(names.substr(0, ends[i]), isOutside);
            if (library) length = ends[i];
        }
        if (library) {
            to.found.push_back(*library);
        } else {
            addName(isOutside ? to.outside : to.missing, unquoted(names.substr(0, length)));
        }
        names.remove_prefix(length);
        names.remove_prefix(std::min(names.find_first_not_of(" \t"), names.size()));
    }
}

std::vector<MaterialLibrary> LibraryFinder::find(std::string_view names) {
    Search search;
    findSeveral(names, search);
    if (search.found.empty()) {
        // Nothing of it is there: the whole may be one name.
        search.missing.clear();
        bool isOutside = false;
        if (const auto namesake = findOne(namesake_.string(), isOutside)) {
            search.found.push_back(*namesake);
        } else if (search.outside.empty()) {
            search.missing.emplace_back(unquoted(names));
        }
    }
    for (const std::string& name : search.missing) addName(missing_, name);
    for (const std::string& name : search.outside) addName(outside_, name);
    return search.found;
}

} // namespace rtcore

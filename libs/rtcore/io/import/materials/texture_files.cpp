#include "rtcore/io/import/materials/texture_files.h"

#include <algorithm>
#include <cctype>

namespace rtcore {

namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// The entry of `folder` that is called `name` but for the case of its letters; the first by name of several.
std::optional<fs::path> entryAnyCase(const fs::path& folder, const std::string& name) {
    std::error_code error;
    std::optional<fs::path> found;
    const std::string wanted = lower(name);
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        if (lower(it->path().filename().string()) != wanted) continue;
        if (!found || it->path() < *found) found = it->path();
    }
    return found;
}

} // namespace

std::optional<fs::path> fileOfAnyCase(const fs::path& folder, const fs::path& relative) {
    std::error_code error;
    const fs::path direct = folder / relative;
    if (fs::is_regular_file(direct, error)) return direct;
    fs::path at = relative.is_absolute() ? relative.root_path() : folder;
    for (const fs::path& part : relative.relative_path()) {
        if (part == "." || part == ".." || fs::exists(at / part, error)) {
            at /= part;
        } else if (const auto entry = entryAnyCase(at, part.string())) {
            at = *entry;
        } else {
            return {};
        }
    }
    if (!fs::is_regular_file(at, error)) return {};
    return at;
}

std::vector<fs::path> shorterPaths(const fs::path& path) {
    constexpr std::size_t kMaxParts = 32;
    std::vector<fs::path> shorter;
    if (!path.has_filename()) return shorter;
    fs::path rest;
    for (auto part = --path.end(); part != path.begin() && shorter.size() < kMaxParts; --part) {
        rest = rest.empty() ? *part : *part / rest;
        if (*part != "." && *part != "..") shorter.push_back(rest);
    }
    std::ranges::reverse(shorter);
    return shorter;
}

std::string percentDecoded(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto hex = [&](std::size_t k) {
            return k < text.size() && std::isxdigit(static_cast<unsigned char>(text[k])) != 0;
        };
        if (text[i] == '%' && hex(i + 1) && hex(i + 2)) {
            out += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            out += text[i];
        }
    }
    return out;
}

std::optional<fs::path> findTextureFile(const fs::path& folder, const std::string& name) {
    std::string spelled = name.substr(0, name.find('\0'));
    spelled.resize(spelled.find_last_not_of(" \t\r") + 1); // some programs write a blank behind it
    std::replace(spelled.begin(), spelled.end(), '\\', '/');
    if (spelled.empty() || spelled.size() > 4096) return {};
    const std::string decoded = percentDecoded(spelled);
    for (const std::string& path : {spelled, decoded}) {
        if (auto file = fileOfAnyCase(folder, path)) return file;
    }
    for (const fs::path& shorter : shorterPaths(decoded))
        if (auto file = fileOfAnyCase(folder, shorter)) return file;
    const fs::path last = fs::path(decoded).filename();
    for (const char* place : {"textures", "../textures"}) {
        if (auto file = fileOfAnyCase(folder, fs::path(place) / last)) return file;
    }
    return {};
}

} // namespace rtcore

#include "renderer/output_names.h"

#include "renderer/film_format.h"

#include "common/cli/command_line.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <system_error>

namespace renderer {

namespace {

[[noreturn]] void failRange() {
    throw app::UsageError("option '--frames' takes a frame number from 1 or a range, such as 3-9");
}

int frameNumber(std::string_view text, int fallback) {
    if (text.empty()) return fallback;
    const std::optional<std::int64_t> number = app::parseInteger(text);
    if (!number || *number < 1 || *number > INT_MAX) failRange();
    return static_cast<int>(*number);
}

} // namespace

FrameRange parseFrameRange(std::string_view text) {
    const std::size_t dash = text.find('-');
    if (dash == std::string_view::npos && !text.empty()) {
        const int number = frameNumber(text, 1);
        return {number, number};
    }
    if (text.size() < 2) failRange();
    const FrameRange range{frameNumber(text.substr(0, dash), 1), frameNumber(text.substr(dash + 1), INT_MAX)};
    if (range.first > range.last) {
        throw app::UsageError("option '--frames': the range " + std::string(text) + " is empty");
    }
    return range;
}

Chunk parseChunk(std::string_view text) {
    const std::size_t slash = text.find('/');
    const auto number = [&](std::string_view digits) { return app::parseInteger(digits).value_or(0); };
    const std::int64_t part = number(text.substr(0, slash));
    const std::int64_t parts = slash == std::string_view::npos ? 0 : number(text.substr(slash + 1));
    if (part < 1 || part > parts || parts > INT_MAX) {
        throw app::UsageError("option '--chunk' takes I/N with I from 1 to N, such as 3/10");
    }
    return {static_cast<int>(part), static_cast<int>(parts)};
}

std::filesystem::path numberedPath(const std::filesystem::path& pattern, int number, bool always) {
    std::string name = pattern.filename().string();
    std::size_t last = name.find_last_of('#');
    if (last == std::string::npos) {
        if (!always) return pattern;
        const std::size_t stem = pattern.stem().string().size();
        name.insert(stem, "_####");
        last = stem + 4;
    }
    const std::size_t before = name.find_last_not_of('#', last);
    const std::size_t first = before == std::string::npos ? 0 : before + 1;
    const std::size_t width = last - first + 1;
    name.replace(first, width, fmt::format("{:0{}}", number, width));
    return pattern.parent_path() / name;
}

void checkOutput(const std::filesystem::path& path, MissingFolder missing) {
    if (isStandardOutput(path)) return;
    if (!rtcore::isWritableFormat(path)) {
        throw app::UsageError(rtcore::say(
            "{0}: {1}", path.string(),
            rtcore::say("cannot write images with this extension, only {0}", rtcore::writableFormats())));
    }
    checkPlace(path, missing);
}

bool makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    const bool made = !folder.empty() && std::filesystem::create_directory(folder, error);
    if (error)
        throw rtcore::FileError(
            rtcore::FailureKind::CannotWrite, folder.string(),
            rtcore::say("the folder cannot be made: {0}", rtcore::systemReason(error.value())));
    return made;
}

void checkAovs(std::span<const std::filesystem::path> patterns) {
    const auto holds = [](const std::filesystem::path& path) { return rtcore::isExr(path); };
    if (std::none_of(patterns.begin(), patterns.end(), holds)) {
        throw app::UsageError("--aovs needs an output with the extension .exr, which can hold them");
    }
}

void checkAlpha(std::span<const std::filesystem::path> patterns, const std::string& standard) {
    for (const std::filesystem::path& pattern : patterns) {
        const std::filesystem::path name =
            isStandardOutput(pattern) ? std::filesystem::path("-." + standard) : pattern;
        if (!rtcore::keepsAlpha(name))
            throw app::UsageError(
                "--alpha: " + name.string() +
                " cannot hold it; give an output that ends in .png, .tif, .tga, .webp or .exr");
    }
}

void checkBackdrop(std::span<const std::filesystem::path> patterns) {
    for (const std::filesystem::path& pattern : patterns) {
        if (!isStandardOutput(pattern) && rtcore::isHdrFormat(pattern))
            throw app::UsageError("--backdrop is of what a display shows, and " + pattern.string() +
                                  " holds radiance; give --alpha with an .exr in its place");
    }
}

void checkFilm(const std::filesystem::path& film) {
    if (!isFilm(film)) {
        throw app::UsageError(film.string() + ": cannot write films with this extension, only " +
                              filmExtensions());
    }
    checkPlace(film);
}

void checkPlace(const std::filesystem::path& path, MissingFolder missing) {
    const auto refuse = [&](const rtcore::Sentence& reason) {
        throw rtcore::FileError(rtcore::FailureKind::CannotWrite, path.string(), reason);
    };
    std::error_code ignored;
    std::filesystem::path folder = path.parent_path();
    if (missing == MissingFolder::Make && !std::filesystem::exists(folder, ignored))
        folder = folder.parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
        refuse(rtcore::say("there is no folder {0}; make it first", folder.string()));
    }
    if (std::filesystem::is_directory(path, ignored)) refuse("this is a folder; name a file in it");
}

} // namespace renderer

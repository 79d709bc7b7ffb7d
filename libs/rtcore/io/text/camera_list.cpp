#include "rtcore/io/text/camera_list.h"

#include "rtcore/io/text/text_file.h"
#include "rtcore/platform/error.h"

#include <algorithm>

namespace rtcore {

namespace {

constexpr std::string_view kWhiteSpace = " \t\r";

/// Without a comment and the white space around.
std::string_view trimmedLine(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool starts = i == 0 || kWhiteSpace.find(line[i - 1]) != std::string_view::npos;
        if (line[i] == '#' && starts) line = line.substr(0, i);
    }
    const auto first = line.find_first_not_of(kWhiteSpace);
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(kWhiteSpace) - first + 1);
}

std::string_view withoutByteOrderMark(std::string_view text) {
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

void checkText(std::string_view text, const std::string& file) {
    const std::size_t invalid = std::min(findInvalidUtf8(text), text.find('\0'));
    if (invalid == std::string_view::npos) return;
    const TextPosition position = positionAt(text, invalid);
    throw FileError(FailureKind::BadData, file, "this byte is no text; save the list as UTF-8", position.line,
                    position.column);
}

std::string listLine(const std::filesystem::path& list, const std::filesystem::path& camera) {
    std::string line = pathToUtf8(pathSeenFrom(list.parent_path(), camera));
    if (line.starts_with('#')) line.insert(0, "./");
    const bool holds = trimmedLine(line) == line && line.find('\n') == std::string::npos;
    if (!holds || camera.empty())
        throw FileError(FailureKind::CannotWrite, list.string(),
                        "a list cannot hold the path '" + camera.string() + "'; rename the file");
    return line + "\n";
}

} // namespace

std::vector<std::filesystem::path> parseCameraList(std::string_view text, const std::filesystem::path& path) {
    const std::string name = path.string();
    const std::filesystem::path folder = path.parent_path();
    std::vector<std::filesystem::path> cameras;
    checkText(text, name);
    text = withoutByteOrderMark(text);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::string_view camera = trimmedLine(line);
        if (!camera.empty()) cameras.push_back(folder / pathFromUtf8(camera));
    }
    return cameras;
}

std::vector<std::filesystem::path> readCameraList(const std::filesystem::path& path) {
    return parseCameraList(readShortText(path), path);
}

void writeCameraList(const std::filesystem::path& path, std::span<const std::filesystem::path> cameras) {
    std::string text;
    for (const std::filesystem::path& camera : cameras) text += listLine(path, camera);
    writeCheckedText(path, text, [&](std::string_view written) { parseCameraList(written, path); });
}

} // namespace rtcore

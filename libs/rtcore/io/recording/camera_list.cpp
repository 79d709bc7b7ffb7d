#include "rtcore/io/recording/camera_list.h"

#include "rtcore/io/text/text_file.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/utf8.h"

#include <algorithm>
#include <system_error>

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

std::string_view completeLines(std::string_view text) {
    const std::size_t last = text.rfind('\n');
    return last == std::string_view::npos ? std::string_view{} : text.substr(0, last + 1);
}

std::string_view withoutSpace(std::string_view line) {
    const auto first = line.find_first_not_of(kWhiteSpace);
    return first == std::string_view::npos
               ? std::string_view{}
               : line.substr(first, line.find_last_not_of(kWhiteSpace) - first + 1);
}

bool isRecording(std::string_view text) {
    text = withoutByteOrderMark(text);
    const std::size_t end = text.find('\n');
    return end != std::string_view::npos && withoutSpace(text.substr(0, end)) == kRecordingMark;
}

} // namespace

GrowingCameraList parseGrowingCameraList(std::string_view text, const std::filesystem::path& path) {
    text = completeLines(text);
    checkText(text, path.string());
    text = withoutByteOrderMark(text);
    const std::filesystem::path folder = path.parent_path();
    GrowingCameraList list;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = withoutSpace(text.substr(0, end));
        text.remove_prefix(end + 1);
        const std::string_view camera = trimmedLine(line);
        if (!camera.empty()) list.cameras.push_back(folder / pathFromUtf8(camera));
        if (!line.empty()) list.ended = line == kEndMark;
    }
    return list;
}

GrowingCameraList readGrowingCameraList(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return {};
    return parseGrowingCameraList(readShortText(path), path);
}

std::string cameraListLine(const std::filesystem::path& list, const std::filesystem::path& camera) {
    std::string line = pathToUtf8(pathSeenFrom(list.parent_path(), camera));
    if (line.starts_with('#')) line.insert(0, "./");
    const bool holds = trimmedLine(line) == line && line.find('\n') == std::string::npos;
    if (!holds || camera.empty())
        throw FileError(FailureKind::CannotWrite, list.string(),
                        say("a list cannot hold the path '{0}'; rename the file", camera.string()));
    return line + "\n";
}

std::vector<std::filesystem::path> parseCameraList(std::string_view text, const std::filesystem::path& path) {
    const bool whole = text.empty() || text.ends_with('\n') || isRecording(text);
    // In a list that was typed, the last line may lack its end.
    return parseGrowingCameraList(whole ? text : std::string(text) + "\n", path).cameras;
}

std::vector<std::filesystem::path> readCameraList(const std::filesystem::path& path) {
    return parseCameraList(readShortText(path), path);
}

void writeCameraList(const std::filesystem::path& path, std::span<const std::filesystem::path> cameras) {
    std::string text;
    for (const std::filesystem::path& camera : cameras) text += cameraListLine(path, camera);
    writeCheckedText(path, text, [&](std::string_view written) { parseCameraList(written, path); });
}

} // namespace rtcore

#include "rtcore/platform/error.h"

#include "rtcore/platform/sentence.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

namespace rtcore {

namespace {

Sentence whole(const std::string& file, const Sentence& message, int line, int column) {
    std::string text = file;
    if (line > 0) text += fmt::format(":{}", line);
    if (line > 0 && column > 0) text += fmt::format(":{}", column);
    return text.empty() ? message : say("{0}: {1}", text, message);
}

// Those that people meet; others stay as the system says them.
constexpr std::array kReasons{form("No such file or directory"),
                              form("Permission denied"),
                              form("No space left on device"),
                              form("Disk quota exceeded"),
                              form("Is a directory"),
                              form("Not a directory"),
                              form("File exists"),
                              form("File name too long"),
                              form("Read-only file system"),
                              form("Operation not permitted"),
                              form("Input/output error"),
                              form("Too many open files"),
                              form("Too many levels of symbolic links"),
                              form("Cannot allocate memory"),
                              form("Directory not empty"),
                              form("File too large")};

} // namespace

Sentence systemReason(int error) {
    const std::string reason = std::generic_category().message(error);
    const auto* const known =
        std::ranges::find(kReasons, reason, [](const char* each) { return std::string_view(each); });
    return known == kReasons.end() ? Sentence(reason) : Sentence(*known);
}

FileError::FileError(FailureKind failure, const std::string& file, const Sentence& message, int line,
                     int column)
    : FileError(failure, whole(file, message, line, column)) {}

FileError::FileError(FailureKind failure, const Sentence& whole)
    : std::runtime_error(whole.english()), Worded(whole), kind(failure) {}

} // namespace rtcore

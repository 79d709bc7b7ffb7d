#include "rtcore/platform/error.h"

#include <fmt/core.h>

namespace rtcore {

namespace {

std::string whole(const std::string& file, const std::string& message, int line, int column) {
    std::string text = file;
    if (line > 0) text += fmt::format(":{}", line);
    if (line > 0 && column > 0) text += fmt::format(":{}", column);
    return text.empty() ? message : fmt::format("{}: {}", text, message);
}

} // namespace

FileError::FileError(FailureKind failure, const std::string& file, const std::string& message, int line,
                     int column)
    : std::runtime_error(whole(file, message, line, column)), kind(failure) {}

} // namespace rtcore

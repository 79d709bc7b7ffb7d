#include "bridge/tokens.h"

#include "bridge/net/doorkeeper.h"

#include "common/process/private_files.h"

#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <sstream>

namespace bridge {

namespace {

bool isToken(const std::string& text) {
    constexpr std::size_t kMin = 22, kMax = 128;
    const bool plain =
        text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_") ==
        std::string::npos;
    return plain && text.size() >= kMin && text.size() <= kMax;
}

/// Replaces `tokens` by those in the file; writes them to it where there is no file.
void keepTokens(const std::string& path, Tokens& tokens) {
    std::optional<std::string> text = app::readPrivateFile(path);
    if (!text) {
        if (app::writePrivateFile(path, fmt::format("{}\n{}\n", tokens.driver, tokens.viewer))) return;
        text = app::readPrivateFile(path); // another bridge was quicker
    }
    std::istringstream lines(text.value_or(""));
    std::getline(lines, tokens.driver);
    std::getline(lines, tokens.viewer);
    if (isToken(tokens.driver) && isToken(tokens.viewer) && tokens.driver != tokens.viewer) return;
    throw rtcore::FileError(
        rtcore::FailureKind::BadData, path,
        "it takes two lines, the driver's and the viewer's token, of at least 22 letters, "
        "digits, - or _");
}

} // namespace

Tokens openTokens(const std::optional<std::filesystem::path>& file, bool viewOnly) {
    Tokens tokens{.driver = newToken(), .viewer = newToken()};
    if (file) keepTokens(file->string(), tokens);
    tokens.lasting = file.has_value();
    if (viewOnly) tokens.driver.clear();
    return tokens;
}

} // namespace bridge
